<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis hasScaleBasedVisibilityFlag="0" version="3.40.6-Bratislava" simplifyDrawingTol="1" simplifyAlgorithm="0" autoRefreshMode="Disabled" minScale="100000000" simplifyMaxScale="1" simplifyLocal="1" symbologyReferenceScale="-1" styleCategories="Symbology|Symbology3D|Labeling|Fields|Forms|MapTips|AttributeTable|Rendering|Temporal|Elevation" maxScale="0" autoRefreshTime="0" simplifyDrawingHints="1" labelsEnabled="0">
  <temporal enabled="0" accumulate="0" durationField="" endExpression="" startExpression="" limitMode="0" mode="0" fixedDuration="0" startField="" endField="" durationUnit="min">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <elevation extrusionEnabled="0" zoffset="0" extrusion="0" type="IndividualFeatures" clamping="Absolute" zscale="1" respectLayerSymbol="0" showMarkerSymbolInSurfacePlots="1" binding="Vertex" symbology="Line">
    <data-defined-properties>
      <Option type="Map">
        <Option name="name" type="QString" value=""/>
        <Option name="properties"/>
        <Option name="type" type="QString" value="collection"/>
      </Option>
    </data-defined-properties>
    <profileLineSymbol>
      <symbol alpha="1" name="" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer enabled="1" pass="0" class="SimpleLine" locked="0" id="{5636d771-b0d8-4859-a06c-a9b9537c7f12}">
          <Option type="Map">
            <Option name="align_dash_pattern" type="QString" value="0"/>
            <Option name="capstyle" type="QString" value="square"/>
            <Option name="customdash" type="QString" value="5;2"/>
            <Option name="customdash_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="customdash_unit" type="QString" value="MM"/>
            <Option name="dash_pattern_offset" type="QString" value="0"/>
            <Option name="dash_pattern_offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="dash_pattern_offset_unit" type="QString" value="MM"/>
            <Option name="draw_inside_polygon" type="QString" value="0"/>
            <Option name="joinstyle" type="QString" value="bevel"/>
            <Option name="line_color" type="QString" value="68,80,90,255,rgb:0.26666666666666666,0.31372549019607843,0.35294117647058826,1"/>
            <Option name="line_style" type="QString" value="solid"/>
            <Option name="line_width" type="QString" value="0.12"/>
            <Option name="line_width_unit" type="QString" value="MM"/>
            <Option name="offset" type="QString" value="0"/>
            <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="offset_unit" type="QString" value="MM"/>
            <Option name="ring_filter" type="QString" value="0"/>
            <Option name="trim_distance_end" type="QString" value="0"/>
            <Option name="trim_distance_end_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="trim_distance_end_unit" type="QString" value="MM"/>
            <Option name="trim_distance_start" type="QString" value="0"/>
            <Option name="trim_distance_start_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="trim_distance_start_unit" type="QString" value="MM"/>
            <Option name="tweak_dash_pattern_on_corners" type="QString" value="0"/>
            <Option name="use_custom_dash" type="QString" value="0"/>
            <Option name="width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileLineSymbol>
    <profileFillSymbol>
      <symbol alpha="1" name="" frame_rate="10" type="fill" is_animated="0" force_rhr="0" clip_to_extent="1">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer enabled="1" pass="0" class="SimpleFill" locked="0" id="{adcc1ade-41cc-4962-b091-e2b22132fb8e}">
          <Option type="Map">
            <Option name="border_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="color" type="QString" value="159,184,182,255,rgb:0.62352941176470589,0.72156862745098038,0.71372549019607845,1"/>
            <Option name="joinstyle" type="QString" value="bevel"/>
            <Option name="offset" type="QString" value="0,0"/>
            <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="offset_unit" type="QString" value="MM"/>
            <Option name="outline_color" type="QString" value="68,80,90,255,rgb:0.26666666666666666,0.31372549019607843,0.35294117647058826,1"/>
            <Option name="outline_style" type="QString" value="solid"/>
            <Option name="outline_width" type="QString" value="0.2"/>
            <Option name="outline_width_unit" type="QString" value="MM"/>
            <Option name="style" type="QString" value="solid"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileFillSymbol>
    <profileMarkerSymbol>
      <symbol alpha="1" name="" frame_rate="10" type="marker" is_animated="0" force_rhr="0" clip_to_extent="1">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer enabled="1" pass="0" class="SimpleMarker" locked="0" id="{1e312030-39c4-4b09-bb01-1cf0b4b028fa}">
          <Option type="Map">
            <Option name="angle" type="QString" value="0"/>
            <Option name="cap_style" type="QString" value="square"/>
            <Option name="color" type="QString" value="14,107,168,255,rgb:0.05490196078431372,0.41960784313725491,0.6588235294117647,1"/>
            <Option name="horizontal_anchor_point" type="QString" value="1"/>
            <Option name="joinstyle" type="QString" value="bevel"/>
            <Option name="name" type="QString" value="circle"/>
            <Option name="offset" type="QString" value="0,0"/>
            <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="offset_unit" type="QString" value="MM"/>
            <Option name="outline_color" type="QString" value="35,35,35,255,rgb:0.13725490196078433,0.13725490196078433,0.13725490196078433,1"/>
            <Option name="outline_style" type="QString" value="no"/>
            <Option name="outline_width" type="QString" value="0"/>
            <Option name="outline_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="outline_width_unit" type="QString" value="MM"/>
            <Option name="scale_method" type="QString" value="diameter"/>
            <Option name="size" type="QString" value="1.8"/>
            <Option name="size_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
            <Option name="size_unit" type="QString" value="MM"/>
            <Option name="vertical_anchor_point" type="QString" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileMarkerSymbol>
  </elevation>
  <renderer-v2 type="RuleRenderer" symbollevels="0" referencescale="-1" enableorderby="0" forceraster="0">
    <rules key="{05842cb2-3cd6-4c9f-8c0c-23b555b23efa}">
      <rule filter="&quot;known_by&quot; = 'targets'" key="{81763b21-c5bc-4906-8b6e-08e3a1e51393}" symbol="0" label="error as targets see it"/>
      <rule filter="&quot;known_by&quot; = 'units'" key="{738fb05e-5597-4973-b821-e099faa8dcf8}" symbol="1" label="difference of two epochs as units see it"/>
      <rule filter="&quot;known_by&quot; = 'strips'" key="{ef5bf02d-01e9-4132-8dbd-971211b7e391}" symbol="2" label="strip against its epoch"/>
    </rules>
    <symbols>
      <symbol alpha="1" name="0" frame_rate="10" type="marker" is_animated="0" force_rhr="0" clip_to_extent="1">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer enabled="1" pass="0" class="GeometryGenerator" locked="0" id="{33b03fc0-776b-40d0-9e32-4f830c24e344}">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Line"/>
            <Option name="geometryModifier" type="QString" value="boundary(make_ellipse($x+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;de&quot;,$y+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;dn&quot;,0.4896*@map_scale*&quot;sd_e&quot;,0.4896*@map_scale*&quot;sd_n&quot;,0))"/>
            <Option name="units" type="QString" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" name="@0@0" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer enabled="1" pass="0" class="SimpleLine" locked="0" id="{b29d16b7-b6b2-47a4-9a27-470b4e9c1b4c}">
              <Option type="Map">
                <Option name="align_dash_pattern" type="QString" value="0"/>
                <Option name="capstyle" type="QString" value="square"/>
                <Option name="customdash" type="QString" value="5;2"/>
                <Option name="customdash_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="customdash_unit" type="QString" value="MM"/>
                <Option name="dash_pattern_offset" type="QString" value="0"/>
                <Option name="dash_pattern_offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="dash_pattern_offset_unit" type="QString" value="MM"/>
                <Option name="draw_inside_polygon" type="QString" value="0"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="line_color" type="QString" value="86,160,216,255,rgb:0.33725490196078434,0.62745098039215685,0.84705882352941175,1"/>
                <Option name="line_style" type="QString" value="solid"/>
                <Option name="line_width" type="QString" value="0.2"/>
                <Option name="line_width_unit" type="QString" value="MM"/>
                <Option name="offset" type="QString" value="0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="ring_filter" type="QString" value="0"/>
                <Option name="trim_distance_end" type="QString" value="0"/>
                <Option name="trim_distance_end_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="trim_distance_end_unit" type="QString" value="MM"/>
                <Option name="trim_distance_start" type="QString" value="0"/>
                <Option name="trim_distance_start_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="trim_distance_start_unit" type="QString" value="MM"/>
                <Option name="tweak_dash_pattern_on_corners" type="QString" value="0"/>
                <Option name="use_custom_dash" type="QString" value="0"/>
                <Option name="width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties"/>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer enabled="1" pass="0" class="GeometryGenerator" locked="0" id="{681227ee-a20e-4b19-9053-511864025387}">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Line"/>
            <Option name="geometryModifier" type="QString" value="make_line(make_point($x,$y),make_point($x+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;de&quot;,$y+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;dn&quot;))"/>
            <Option name="units" type="QString" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" name="@0@1" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer enabled="1" pass="0" class="ArrowLine" locked="0" id="{6dd48e8a-7ac2-463b-8da3-d4c2d0f883ab}">
              <Option type="Map">
                <Option name="arrow_start_width" type="QString" value="0.6"/>
                <Option name="arrow_start_width_unit" type="QString" value="MM"/>
                <Option name="arrow_start_width_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="arrow_type" type="QString" value="0"/>
                <Option name="arrow_width" type="QString" value="0.6"/>
                <Option name="arrow_width_unit" type="QString" value="MM"/>
                <Option name="arrow_width_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_length" type="QString" value="1.92"/>
                <Option name="head_length_unit" type="QString" value="MM"/>
                <Option name="head_length_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_thickness" type="QString" value="1.12"/>
                <Option name="head_thickness_unit" type="QString" value="MM"/>
                <Option name="head_thickness_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_type" type="QString" value="0"/>
                <Option name="is_curved" type="QString" value="0"/>
                <Option name="is_repeated" type="QString" value="1"/>
                <Option name="offset" type="QString" value="0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="offset_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="ring_filter" type="QString" value="0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties"/>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
              <symbol alpha="1" name="@@0@1@0" frame_rate="10" type="fill" is_animated="0" force_rhr="0" clip_to_extent="1">
                <data_defined_properties>
                  <Option type="Map">
                    <Option name="name" type="QString" value=""/>
                    <Option name="properties"/>
                    <Option name="type" type="QString" value="collection"/>
                  </Option>
                </data_defined_properties>
                <layer enabled="1" pass="0" class="SimpleFill" locked="0" id="{914075c2-22ae-4782-a082-b5cf1d9d1cd7}">
                  <Option type="Map">
                    <Option name="border_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                    <Option name="color" type="QString" value="86,160,216,255,rgb:0.33725490196078434,0.62745098039215685,0.84705882352941175,1"/>
                    <Option name="joinstyle" type="QString" value="bevel"/>
                    <Option name="offset" type="QString" value="0,0"/>
                    <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                    <Option name="offset_unit" type="QString" value="MM"/>
                    <Option name="outline_color" type="QString" value="255,255,255,255,rgb:1,1,1,1"/>
                    <Option name="outline_style" type="QString" value="solid"/>
                    <Option name="outline_width" type="QString" value="0.1"/>
                    <Option name="outline_width_unit" type="QString" value="MM"/>
                    <Option name="style" type="QString" value="solid"/>
                  </Option>
                  <data_defined_properties>
                    <Option type="Map">
                      <Option name="name" type="QString" value=""/>
                      <Option name="properties"/>
                      <Option name="type" type="QString" value="collection"/>
                    </Option>
                  </data_defined_properties>
                </layer>
              </symbol>
            </layer>
          </symbol>
        </layer>
      </symbol>
      <symbol alpha="1" name="1" frame_rate="10" type="marker" is_animated="0" force_rhr="0" clip_to_extent="1">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer enabled="1" pass="0" class="GeometryGenerator" locked="0" id="{70675b3e-5fe5-40c9-9343-a3795ce2663b}">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Line"/>
            <Option name="geometryModifier" type="QString" value="boundary(make_ellipse($x+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;de&quot;,$y+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;dn&quot;,0.4896*@map_scale*&quot;sd_e&quot;,0.4896*@map_scale*&quot;sd_n&quot;,0))"/>
            <Option name="units" type="QString" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" name="@1@0" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer enabled="1" pass="0" class="SimpleLine" locked="0" id="{4a1f4aab-0b76-4da0-ba22-9e223fd36300}">
              <Option type="Map">
                <Option name="align_dash_pattern" type="QString" value="0"/>
                <Option name="capstyle" type="QString" value="square"/>
                <Option name="customdash" type="QString" value="5;2"/>
                <Option name="customdash_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="customdash_unit" type="QString" value="MM"/>
                <Option name="dash_pattern_offset" type="QString" value="0"/>
                <Option name="dash_pattern_offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="dash_pattern_offset_unit" type="QString" value="MM"/>
                <Option name="draw_inside_polygon" type="QString" value="0"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="line_color" type="QString" value="59,15,92,255,rgb:0.23137254901960785,0.05882352941176471,0.36078431372549019,1"/>
                <Option name="line_style" type="QString" value="solid"/>
                <Option name="line_width" type="QString" value="0.2"/>
                <Option name="line_width_unit" type="QString" value="MM"/>
                <Option name="offset" type="QString" value="0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="ring_filter" type="QString" value="0"/>
                <Option name="trim_distance_end" type="QString" value="0"/>
                <Option name="trim_distance_end_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="trim_distance_end_unit" type="QString" value="MM"/>
                <Option name="trim_distance_start" type="QString" value="0"/>
                <Option name="trim_distance_start_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="trim_distance_start_unit" type="QString" value="MM"/>
                <Option name="tweak_dash_pattern_on_corners" type="QString" value="0"/>
                <Option name="use_custom_dash" type="QString" value="0"/>
                <Option name="width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties"/>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer enabled="1" pass="0" class="GeometryGenerator" locked="0" id="{8d8f9b99-aec7-4a9b-88b7-2fbe792be9c2}">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Line"/>
            <Option name="geometryModifier" type="QString" value="make_line(make_point($x,$y),make_point($x+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;de&quot;,$y+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;dn&quot;))"/>
            <Option name="units" type="QString" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" name="@1@1" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer enabled="1" pass="0" class="ArrowLine" locked="0" id="{c83b324d-c48f-471a-b9b0-049a92ab1f40}">
              <Option type="Map">
                <Option name="arrow_start_width" type="QString" value="0.6"/>
                <Option name="arrow_start_width_unit" type="QString" value="MM"/>
                <Option name="arrow_start_width_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="arrow_type" type="QString" value="0"/>
                <Option name="arrow_width" type="QString" value="0.6"/>
                <Option name="arrow_width_unit" type="QString" value="MM"/>
                <Option name="arrow_width_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_length" type="QString" value="1.92"/>
                <Option name="head_length_unit" type="QString" value="MM"/>
                <Option name="head_length_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_thickness" type="QString" value="1.12"/>
                <Option name="head_thickness_unit" type="QString" value="MM"/>
                <Option name="head_thickness_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_type" type="QString" value="0"/>
                <Option name="is_curved" type="QString" value="0"/>
                <Option name="is_repeated" type="QString" value="1"/>
                <Option name="offset" type="QString" value="0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="offset_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="ring_filter" type="QString" value="0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties"/>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
              <symbol alpha="1" name="@@1@1@0" frame_rate="10" type="fill" is_animated="0" force_rhr="0" clip_to_extent="1">
                <data_defined_properties>
                  <Option type="Map">
                    <Option name="name" type="QString" value=""/>
                    <Option name="properties"/>
                    <Option name="type" type="QString" value="collection"/>
                  </Option>
                </data_defined_properties>
                <layer enabled="1" pass="0" class="SimpleFill" locked="0" id="{a4dbe092-9862-4de8-8c6d-8d9eafc4e233}">
                  <Option type="Map">
                    <Option name="border_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                    <Option name="color" type="QString" value="59,15,92,255,rgb:0.23137254901960785,0.05882352941176471,0.36078431372549019,1"/>
                    <Option name="joinstyle" type="QString" value="bevel"/>
                    <Option name="offset" type="QString" value="0,0"/>
                    <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                    <Option name="offset_unit" type="QString" value="MM"/>
                    <Option name="outline_color" type="QString" value="255,255,255,255,rgb:1,1,1,1"/>
                    <Option name="outline_style" type="QString" value="solid"/>
                    <Option name="outline_width" type="QString" value="0.1"/>
                    <Option name="outline_width_unit" type="QString" value="MM"/>
                    <Option name="style" type="QString" value="solid"/>
                  </Option>
                  <data_defined_properties>
                    <Option type="Map">
                      <Option name="name" type="QString" value=""/>
                      <Option name="properties"/>
                      <Option name="type" type="QString" value="collection"/>
                    </Option>
                  </data_defined_properties>
                </layer>
              </symbol>
            </layer>
          </symbol>
        </layer>
      </symbol>
      <symbol alpha="1" name="2" frame_rate="10" type="marker" is_animated="0" force_rhr="0" clip_to_extent="1">
        <data_defined_properties>
          <Option type="Map">
            <Option name="name" type="QString" value=""/>
            <Option name="properties"/>
            <Option name="type" type="QString" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer enabled="1" pass="0" class="GeometryGenerator" locked="0" id="{48cc6711-59ad-4611-90af-250c1d0a2b45}">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Line"/>
            <Option name="geometryModifier" type="QString" value="boundary(make_ellipse($x+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;de&quot;,$y+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;dn&quot;,0.4896*@map_scale*&quot;sd_e&quot;,0.4896*@map_scale*&quot;sd_n&quot;,0))"/>
            <Option name="units" type="QString" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" name="@2@0" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer enabled="1" pass="0" class="SimpleLine" locked="0" id="{c76a2121-9b38-406a-a04e-baa0fcacb7dd}">
              <Option type="Map">
                <Option name="align_dash_pattern" type="QString" value="0"/>
                <Option name="capstyle" type="QString" value="square"/>
                <Option name="customdash" type="QString" value="5;2"/>
                <Option name="customdash_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="customdash_unit" type="QString" value="MM"/>
                <Option name="dash_pattern_offset" type="QString" value="0"/>
                <Option name="dash_pattern_offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="dash_pattern_offset_unit" type="QString" value="MM"/>
                <Option name="draw_inside_polygon" type="QString" value="0"/>
                <Option name="joinstyle" type="QString" value="bevel"/>
                <Option name="line_color" type="QString" value="138,148,156,255,rgb:0.54117647058823526,0.58039215686274515,0.61176470588235299,1"/>
                <Option name="line_style" type="QString" value="solid"/>
                <Option name="line_width" type="QString" value="0.2"/>
                <Option name="line_width_unit" type="QString" value="MM"/>
                <Option name="offset" type="QString" value="0"/>
                <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="ring_filter" type="QString" value="0"/>
                <Option name="trim_distance_end" type="QString" value="0"/>
                <Option name="trim_distance_end_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="trim_distance_end_unit" type="QString" value="MM"/>
                <Option name="trim_distance_start" type="QString" value="0"/>
                <Option name="trim_distance_start_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="trim_distance_start_unit" type="QString" value="MM"/>
                <Option name="tweak_dash_pattern_on_corners" type="QString" value="0"/>
                <Option name="use_custom_dash" type="QString" value="0"/>
                <Option name="width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties"/>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer enabled="1" pass="0" class="GeometryGenerator" locked="0" id="{929d075e-f8ec-4495-8269-42e47e93e075}">
          <Option type="Map">
            <Option name="SymbolType" type="QString" value="Line"/>
            <Option name="geometryModifier" type="QString" value="make_line(make_point($x,$y),make_point($x+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;de&quot;,$y+min(0.2, 0.03/max(sqrt(&quot;de&quot;^2+&quot;dn&quot;^2),1e-6))*@map_scale*&quot;dn&quot;))"/>
            <Option name="units" type="QString" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option name="name" type="QString" value=""/>
              <Option name="properties"/>
              <Option name="type" type="QString" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol alpha="1" name="@2@1" frame_rate="10" type="line" is_animated="0" force_rhr="0" clip_to_extent="1">
            <data_defined_properties>
              <Option type="Map">
                <Option name="name" type="QString" value=""/>
                <Option name="properties"/>
                <Option name="type" type="QString" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer enabled="1" pass="0" class="ArrowLine" locked="0" id="{a8b1801c-e31b-4c30-bf9e-d68fd32a4d57}">
              <Option type="Map">
                <Option name="arrow_start_width" type="QString" value="0.6"/>
                <Option name="arrow_start_width_unit" type="QString" value="MM"/>
                <Option name="arrow_start_width_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="arrow_type" type="QString" value="0"/>
                <Option name="arrow_width" type="QString" value="0.6"/>
                <Option name="arrow_width_unit" type="QString" value="MM"/>
                <Option name="arrow_width_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_length" type="QString" value="1.92"/>
                <Option name="head_length_unit" type="QString" value="MM"/>
                <Option name="head_length_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_thickness" type="QString" value="1.12"/>
                <Option name="head_thickness_unit" type="QString" value="MM"/>
                <Option name="head_thickness_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="head_type" type="QString" value="0"/>
                <Option name="is_curved" type="QString" value="0"/>
                <Option name="is_repeated" type="QString" value="1"/>
                <Option name="offset" type="QString" value="0"/>
                <Option name="offset_unit" type="QString" value="MM"/>
                <Option name="offset_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                <Option name="ring_filter" type="QString" value="0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option name="name" type="QString" value=""/>
                  <Option name="properties"/>
                  <Option name="type" type="QString" value="collection"/>
                </Option>
              </data_defined_properties>
              <symbol alpha="1" name="@@2@1@0" frame_rate="10" type="fill" is_animated="0" force_rhr="0" clip_to_extent="1">
                <data_defined_properties>
                  <Option type="Map">
                    <Option name="name" type="QString" value=""/>
                    <Option name="properties"/>
                    <Option name="type" type="QString" value="collection"/>
                  </Option>
                </data_defined_properties>
                <layer enabled="1" pass="0" class="SimpleFill" locked="0" id="{517ed4c7-4451-4837-94b2-1fc33bac5980}">
                  <Option type="Map">
                    <Option name="border_width_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                    <Option name="color" type="QString" value="138,148,156,255,rgb:0.54117647058823526,0.58039215686274515,0.61176470588235299,1"/>
                    <Option name="joinstyle" type="QString" value="bevel"/>
                    <Option name="offset" type="QString" value="0,0"/>
                    <Option name="offset_map_unit_scale" type="QString" value="3x:0,0,0,0,0,0"/>
                    <Option name="offset_unit" type="QString" value="MM"/>
                    <Option name="outline_color" type="QString" value="255,255,255,255,rgb:1,1,1,1"/>
                    <Option name="outline_style" type="QString" value="solid"/>
                    <Option name="outline_width" type="QString" value="0.1"/>
                    <Option name="outline_width_unit" type="QString" value="MM"/>
                    <Option name="style" type="QString" value="solid"/>
                  </Option>
                  <data_defined_properties>
                    <Option type="Map">
                      <Option name="name" type="QString" value=""/>
                      <Option name="properties"/>
                      <Option name="type" type="QString" value="collection"/>
                    </Option>
                  </data_defined_properties>
                </layer>
              </symbol>
            </layer>
          </symbol>
        </layer>
      </symbol>
    </symbols>
    <data-defined-properties>
      <Option type="Map">
        <Option name="name" type="QString" value=""/>
        <Option name="properties"/>
        <Option name="type" type="QString" value="collection"/>
      </Option>
    </data-defined-properties>
  </renderer-v2>
  <selection mode="Default">
    <selectionColor invalid="1"/>
  </selection>
  <blendMode>0</blendMode>
  <featureBlendMode>0</featureBlendMode>
  <layerOpacity>1</layerOpacity>
  <fieldConfiguration>
    <field name="epoch" configurationFlags="NoFlag">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="epoch_from" configurationFlags="NoFlag">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="strip" configurationFlags="NoFlag">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="known_by" configurationFlags="NoFlag">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field name="along" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="de" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="dn" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="dh" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="d_3d" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="sd_e" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="sd_n" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="sd_h" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field name="correlation_length" configurationFlags="NoFlag">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option name="AllowNull" type="bool" value="true"/>
            <Option name="Precision" type="int" value="3"/>
            <Option name="Style" type="QString" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
  </fieldConfiguration>
  <aliases>
    <alias name="Epoch" field="epoch" index="0"/>
    <alias name="From epoch" field="epoch_from" index="1"/>
    <alias name="Strip" field="strip" index="2"/>
    <alias name="Known by" field="known_by" index="3"/>
    <alias name="Along the structure [m]" field="along" index="4"/>
    <alias name="Easting component [m]" field="de" index="5"/>
    <alias name="Northing component [m]" field="dn" index="6"/>
    <alias name="Height component [m]" field="dh" index="7"/>
    <alias name="Displacement [m]" field="d_3d" index="8"/>
    <alias name="Std. dev. easting [m]" field="sd_e" index="9"/>
    <alias name="Std. dev. northing [m]" field="sd_n" index="10"/>
    <alias name="Std. dev. height [m]" field="sd_h" index="11"/>
    <alias name="Correlation length [m]" field="correlation_length" index="12"/>
  </aliases>
  <splitPolicies>
    <policy field="epoch" policy="Duplicate"/>
    <policy field="epoch_from" policy="Duplicate"/>
    <policy field="strip" policy="Duplicate"/>
    <policy field="known_by" policy="Duplicate"/>
    <policy field="along" policy="Duplicate"/>
    <policy field="de" policy="Duplicate"/>
    <policy field="dn" policy="Duplicate"/>
    <policy field="dh" policy="Duplicate"/>
    <policy field="d_3d" policy="Duplicate"/>
    <policy field="sd_e" policy="Duplicate"/>
    <policy field="sd_n" policy="Duplicate"/>
    <policy field="sd_h" policy="Duplicate"/>
    <policy field="correlation_length" policy="Duplicate"/>
  </splitPolicies>
  <duplicatePolicies>
    <policy field="epoch" policy="Duplicate"/>
    <policy field="epoch_from" policy="Duplicate"/>
    <policy field="strip" policy="Duplicate"/>
    <policy field="known_by" policy="Duplicate"/>
    <policy field="along" policy="Duplicate"/>
    <policy field="de" policy="Duplicate"/>
    <policy field="dn" policy="Duplicate"/>
    <policy field="dh" policy="Duplicate"/>
    <policy field="d_3d" policy="Duplicate"/>
    <policy field="sd_e" policy="Duplicate"/>
    <policy field="sd_n" policy="Duplicate"/>
    <policy field="sd_h" policy="Duplicate"/>
    <policy field="correlation_length" policy="Duplicate"/>
  </duplicatePolicies>
  <defaults>
    <default field="epoch" expression="" applyOnUpdate="0"/>
    <default field="epoch_from" expression="" applyOnUpdate="0"/>
    <default field="strip" expression="" applyOnUpdate="0"/>
    <default field="known_by" expression="" applyOnUpdate="0"/>
    <default field="along" expression="" applyOnUpdate="0"/>
    <default field="de" expression="" applyOnUpdate="0"/>
    <default field="dn" expression="" applyOnUpdate="0"/>
    <default field="dh" expression="" applyOnUpdate="0"/>
    <default field="d_3d" expression="" applyOnUpdate="0"/>
    <default field="sd_e" expression="" applyOnUpdate="0"/>
    <default field="sd_n" expression="" applyOnUpdate="0"/>
    <default field="sd_h" expression="" applyOnUpdate="0"/>
    <default field="correlation_length" expression="" applyOnUpdate="0"/>
  </defaults>
  <constraints>
    <constraint constraints="0" unique_strength="0" field="epoch" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="epoch_from" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="strip" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="known_by" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="along" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="de" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="dn" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="dh" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="d_3d" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="sd_e" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="sd_n" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="sd_h" notnull_strength="0" exp_strength="0"/>
    <constraint constraints="0" unique_strength="0" field="correlation_length" notnull_strength="0" exp_strength="0"/>
  </constraints>
  <constraintExpressions>
    <constraint desc="" field="epoch" exp=""/>
    <constraint desc="" field="epoch_from" exp=""/>
    <constraint desc="" field="strip" exp=""/>
    <constraint desc="" field="known_by" exp=""/>
    <constraint desc="" field="along" exp=""/>
    <constraint desc="" field="de" exp=""/>
    <constraint desc="" field="dn" exp=""/>
    <constraint desc="" field="dh" exp=""/>
    <constraint desc="" field="d_3d" exp=""/>
    <constraint desc="" field="sd_e" exp=""/>
    <constraint desc="" field="sd_n" exp=""/>
    <constraint desc="" field="sd_h" exp=""/>
    <constraint desc="" field="correlation_length" exp=""/>
  </constraintExpressions>
  <expressionfields/>
  <attributetableconfig actionWidgetStyle="dropDown" sortExpression="" sortOrder="0">
    <columns>
      <column hidden="0" name="epoch" type="field" width="-1"/>
      <column hidden="0" name="epoch_from" type="field" width="-1"/>
      <column hidden="0" name="strip" type="field" width="-1"/>
      <column hidden="0" name="known_by" type="field" width="-1"/>
      <column hidden="0" name="along" type="field" width="-1"/>
      <column hidden="0" name="de" type="field" width="-1"/>
      <column hidden="0" name="dn" type="field" width="-1"/>
      <column hidden="0" name="dh" type="field" width="-1"/>
      <column hidden="0" name="d_3d" type="field" width="-1"/>
      <column hidden="0" name="sd_e" type="field" width="-1"/>
      <column hidden="0" name="sd_n" type="field" width="-1"/>
      <column hidden="0" name="sd_h" type="field" width="-1"/>
      <column hidden="0" name="correlation_length" type="field" width="-1"/>
      <column hidden="0" type="actions" width="-1"/>
    </columns>
  </attributetableconfig>
  <conditionalstyles>
    <rowstyles/>
    <fieldstyles/>
  </conditionalstyles>
  <storedexpressions/>
  <editform tolerant="1"></editform>
  <editforminit/>
  <editforminitcodesource>0</editforminitcodesource>
  <editforminitfilepath></editforminitfilepath>
  <editforminitcode><![CDATA[]]></editforminitcode>
  <featformsuppress>0</featformsuppress>
  <editorlayout>generatedlayout</editorlayout>
  <editable/>
  <labelOnTop/>
  <reuseLastValue/>
  <dataDefinedFieldProperties/>
  <widgets/>
  <mapTip enabled="1">&lt;b>[% "epoch" %]&lt;/b> [% round("along") %] m&lt;br>[% format_number(coalesce(@tetratrack_factor, 1)*("de"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("dn"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("dh"), coalesce(@tetratrack_decimals, 3)) %] [% coalesce(@tetratrack_unit, 'm') %] (e, n, h), sd [% format_number(coalesce(@tetratrack_factor, 1)*("sd_e"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("sd_n"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("sd_h"), coalesce(@tetratrack_decimals, 3)) %] [% coalesce(@tetratrack_unit, 'm') %]</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
