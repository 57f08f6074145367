<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis simplifyLocal="1" symbologyReferenceScale="-1" version="3.40.6-Bratislava" labelsEnabled="0" styleCategories="Symbology|Symbology3D|Labeling|Fields|Forms|MapTips|AttributeTable|Rendering|Temporal|Elevation" autoRefreshTime="0" hasScaleBasedVisibilityFlag="0" autoRefreshMode="Disabled" minScale="100000000" simplifyMaxScale="1" simplifyDrawingHints="1" maxScale="0" simplifyDrawingTol="1" simplifyAlgorithm="0">
  <renderer-3d type="vector" layer="">
    <vector-layer-3d-tiling show-bounding-boxes="0" zoom-levels-count="3"/>
    <symbol material_type="phong" type="point" shape="sphere">
      <data alt-clamping="absolute"/>
      <material shininess="0" specular="255,255,255,255,rgb:1,1,1,1" ks="1" opacity="1" ka="1" diffuse="14,107,168,255,rgb:0.05490196078431372,0.41960784313725491,0.6588235294117647,1" kd="1" ambient="9,71,112,255,rgb:0.03660639353017472,0.27971313038834211,0.4392156862745098,1">
        <data-defined-properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data-defined-properties>
      </material>
      <shape-properties>
        <Option type="Map">
          <Option type="QString" name="model" value=""/>
          <Option type="double" name="radius" value="0.15"/>
        </Option>
      </shape-properties>
      <transform matrix="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/>
      <symbol clip_to_extent="1" type="marker" name="symbol" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{3c16ea47-7cfb-43e8-8a59-6fa9f83486eb}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="145,82,45,255,rgb:0.56862745098039214,0.32156862745098042,0.17647058823529413,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="35,35,35,255,rgb:0.13725490196078433,0.13725490196078433,0.13725490196078433,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="2"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </symbol>
  </renderer-3d>
  <temporal durationField="" mode="2" endField="epoch_until" startField="epoch_time" durationUnit="min" enabled="1" limitMode="0" startExpression="" fixedDuration="0" accumulate="0" endExpression="">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <elevation symbology="Line" respectLayerSymbol="0" clamping="Absolute" type="IndividualFeatures" showMarkerSymbolInSurfacePlots="1" binding="Vertex" zoffset="0" extrusion="0" zscale="1" extrusionEnabled="0">
    <data-defined-properties>
      <Option type="Map">
        <Option type="QString" name="name" value=""/>
        <Option name="properties"/>
        <Option type="QString" name="type" value="collection"/>
      </Option>
    </data-defined-properties>
    <profileLineSymbol>
      <symbol clip_to_extent="1" type="line" name="" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{169b5e90-93d6-42a5-9a2f-473f61a773ac}">
          <Option type="Map">
            <Option type="QString" name="align_dash_pattern" value="0"/>
            <Option type="QString" name="capstyle" value="square"/>
            <Option type="QString" name="customdash" value="5;2"/>
            <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="customdash_unit" value="MM"/>
            <Option type="QString" name="dash_pattern_offset" value="0"/>
            <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
            <Option type="QString" name="draw_inside_polygon" value="0"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="line_color" value="68,80,90,255,rgb:0.26666666666666666,0.31372549019607843,0.35294117647058826,1"/>
            <Option type="QString" name="line_style" value="solid"/>
            <Option type="QString" name="line_width" value="0.12"/>
            <Option type="QString" name="line_width_unit" value="MM"/>
            <Option type="QString" name="offset" value="0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="ring_filter" value="0"/>
            <Option type="QString" name="trim_distance_end" value="0"/>
            <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="trim_distance_end_unit" value="MM"/>
            <Option type="QString" name="trim_distance_start" value="0"/>
            <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="trim_distance_start_unit" value="MM"/>
            <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
            <Option type="QString" name="use_custom_dash" value="0"/>
            <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileLineSymbol>
    <profileFillSymbol>
      <symbol clip_to_extent="1" type="fill" name="" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="SimpleFill" id="{6f0100a8-d862-41b4-916c-3ace7b47f0f4}">
          <Option type="Map">
            <Option type="QString" name="border_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="color" value="159,184,182,255,rgb:0.62352941176470589,0.72156862745098038,0.71372549019607845,1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="68,80,90,255,rgb:0.26666666666666666,0.31372549019607843,0.35294117647058826,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.2"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="style" value="solid"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileFillSymbol>
    <profileMarkerSymbol>
      <symbol clip_to_extent="1" type="marker" name="" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{8c9f3a64-fa37-4f33-b260-59b111e3f5ae}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="14,107,168,255,rgb:0.05490196078431372,0.41960784313725491,0.6588235294117647,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="35,35,35,255,rgb:0.13725490196078433,0.13725490196078433,0.13725490196078433,1"/>
            <Option type="QString" name="outline_style" value="no"/>
            <Option type="QString" name="outline_width" value="0"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="1.8"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileMarkerSymbol>
  </elevation>
  <renderer-v2 symbollevels="0" type="RuleRenderer" forceraster="0" enableorderby="0" referencescale="-1">
    <rules key="{3e5b1b48-759d-48e4-ae46-15fcec6e0cec}">
      <rule filter="&quot;status&quot; = 'found' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="0" key="{142de654-aec6-4df8-8b12-a3d94e60c47e}" label="found"/>
      <rule filter="&quot;status&quot; = 'uncertain' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="1" key="{bbe5a2f4-2d92-4798-92ed-46cc1e82b138}" label="uncertain"/>
      <rule filter="&quot;status&quot; = 'new' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="2" key="{3c7bea61-e193-4e03-a5ec-2847108ff69c}" label="new"/>
      <rule filter="&quot;status&quot; = 'relocated' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="3" key="{af4b521e-7bb6-4d8b-b5d3-b11656578131}" label="relocated"/>
    </rules>
    <symbols>
      <symbol clip_to_extent="1" type="marker" name="0" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{c3a24f73-4866-402b-8097-5a013a4b224b}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@0@0" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{bc4bdecb-2a07-424e-ace2-8acf40ba52ec}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="255,255,255,255,rgb:1,1,1,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.75"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{8ec201a9-c9a0-4492-9abe-08db41673543}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@0@1" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{8249bf3e-24a0-473b-8f26-8403bf8e6510}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="14,107,168,255,rgb:0.05490196078431372,0.41960784313725491,0.6588235294117647,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.35"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{ddee660e-9467-4f3e-a14c-51fbdbbbe49c}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="255,255,255,255,rgb:1,1,1,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="14,107,168,255,rgb:0.05490196078431372,0.41960784313725491,0.6588235294117647,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.3"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="1.4"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol clip_to_extent="1" type="marker" name="1" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{0bd29d2c-49ab-4646-8b0b-528c65bbad2c}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@1@0" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{104a848d-1e61-4ed5-8257-1bf763e2b757}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="255,255,255,255,rgb:1,1,1,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.75"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{9310b82f-6f94-43a0-b89c-a31c01d33f21}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@1@1" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{a22c0d2e-be88-4585-8f33-c8c0a594bb20}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="138,148,156,255,rgb:0.54117647058823526,0.58039215686274515,0.61176470588235299,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.35"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{6dadfa39-135b-45b4-88f0-5fcf661a3dbd}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="255,255,255,255,rgb:1,1,1,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="138,148,156,255,rgb:0.54117647058823526,0.58039215686274515,0.61176470588235299,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.3"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="1.4"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol clip_to_extent="1" type="marker" name="2" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{dea33767-c17b-4d1c-bfe8-9bb6bb854633}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@2@0" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{3205f42d-4033-458b-8876-1d191492b971}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="255,255,255,255,rgb:1,1,1,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.75"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{2c03b45b-d5de-4a9a-934f-c350331fc869}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@2@1" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{429d337e-bc16-489b-af12-520d475924d8}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="63,191,111,255,rgb:0.24705882352941178,0.74901960784313726,0.43529411764705883,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.35"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{59909b94-5c00-4249-8715-4bc3a7412fac}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="255,255,255,255,rgb:1,1,1,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="63,191,111,255,rgb:0.24705882352941178,0.74901960784313726,0.43529411764705883,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.3"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="1.4"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol clip_to_extent="1" type="marker" name="3" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{47d8dcd1-2216-4a2f-8d33-c85998176e92}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@3@0" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{ad7c06ee-1928-4b7d-b2df-a8ee8a9ad388}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="255,255,255,255,rgb:1,1,1,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.75"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{b1175f48-c472-420b-9d4a-3d5cb51daf7f}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@3@1" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{5c6171bf-2edd-4262-a8f7-3c0edfa758eb}">
              <Option type="Map">
                <Option type="QString" name="align_dash_pattern" value="0"/>
                <Option type="QString" name="capstyle" value="round"/>
                <Option type="QString" name="customdash" value="5;2"/>
                <Option type="QString" name="customdash_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="customdash_unit" value="MM"/>
                <Option type="QString" name="dash_pattern_offset" value="0"/>
                <Option type="QString" name="dash_pattern_offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="dash_pattern_offset_unit" value="MM"/>
                <Option type="QString" name="draw_inside_polygon" value="0"/>
                <Option type="QString" name="joinstyle" value="bevel"/>
                <Option type="QString" name="line_color" value="59,15,92,255,rgb:0.23137254901960785,0.05882352941176471,0.36078431372549019,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.35"/>
                <Option type="QString" name="line_width_unit" value="MM"/>
                <Option type="QString" name="offset" value="0"/>
                <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="offset_unit" value="MM"/>
                <Option type="QString" name="ring_filter" value="0"/>
                <Option type="QString" name="trim_distance_end" value="0"/>
                <Option type="QString" name="trim_distance_end_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_end_unit" value="MM"/>
                <Option type="QString" name="trim_distance_start" value="0"/>
                <Option type="QString" name="trim_distance_start_map_unit_scale" value="3x:0,0,0,0,0,0"/>
                <Option type="QString" name="trim_distance_start_unit" value="MM"/>
                <Option type="QString" name="tweak_dash_pattern_on_corners" value="0"/>
                <Option type="QString" name="use_custom_dash" value="0"/>
                <Option type="QString" name="width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option type="QString" name="name" value=""/>
                  <Option name="properties"/>
                  <Option type="QString" name="type" value="collection"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{9da31111-bb58-4ff2-b387-48de78cd893b}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="255,255,255,255,rgb:1,1,1,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="59,15,92,255,rgb:0.23137254901960785,0.05882352941176471,0.36078431372549019,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.3"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="1.4"/>
            <Option type="QString" name="size_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="vertical_anchor_point" value="1"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </symbols>
    <data-defined-properties>
      <Option type="Map">
        <Option type="QString" name="name" value=""/>
        <Option name="properties"/>
        <Option type="QString" name="type" value="collection"/>
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
    <field configurationFlags="NoFlag" name="unit_id">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="epoch">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="epoch_time">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="epoch_until">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="unit_type">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="height">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="r0">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="gradient">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="qx">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="qy">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="qz">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="qw">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="sd_e">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="sd_n">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="sd_h">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="sd_rotation_deg">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="2"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="covariance">
      <editWidget type="Hidden">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="sigma0">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="n_points">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="legs_visible">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="leg1">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="leg2">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="leg3">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="leg4">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="leg_missing">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="leg_probability">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="coverage">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="score">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="status">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="distance_median">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="supported">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="nearest_centre">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="overlap_share">
      <editWidget type="Range">
        <config>
          <Option type="Map">
            <Option type="bool" name="AllowNull" value="true"/>
            <Option type="int" name="Precision" value="3"/>
            <Option type="QString" name="Style" value="SpinBox"/>
          </Option>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="may_be">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
  </fieldConfiguration>
  <aliases>
    <alias field="unit_id" index="0" name="Unit"/>
    <alias field="epoch" index="1" name="Epoch"/>
    <alias field="epoch_time" index="2" name="Time [UTC]"/>
    <alias field="epoch_until" index="3" name="Until [UTC]"/>
    <alias field="unit_type" index="4" name="Type of unit"/>
    <alias field="height" index="5" name="Height H [m]"/>
    <alias field="r0" index="6" name="r0 [m]"/>
    <alias field="gradient" index="7" name="gradient"/>
    <alias field="qx" index="8" name="qx"/>
    <alias field="qy" index="9" name="qy"/>
    <alias field="qz" index="10" name="qz"/>
    <alias field="qw" index="11" name="qw"/>
    <alias field="sd_e" index="12" name="Std. dev. easting [m]"/>
    <alias field="sd_n" index="13" name="Std. dev. northing [m]"/>
    <alias field="sd_h" index="14" name="Std. dev. height [m]"/>
    <alias field="sd_rotation_deg" index="15" name="Std. dev. rotation [°]"/>
    <alias field="covariance" index="16" name="covariance"/>
    <alias field="sigma0" index="17" name="Sigma 0"/>
    <alias field="n_points" index="18" name="Points"/>
    <alias field="legs_visible" index="19" name="Legs seen"/>
    <alias field="leg1" index="20" name="Leg 1"/>
    <alias field="leg2" index="21" name="Leg 2"/>
    <alias field="leg3" index="22" name="Leg 3"/>
    <alias field="leg4" index="23" name="Leg 4"/>
    <alias field="leg_missing" index="24" name="Missing of a leg [m]"/>
    <alias field="leg_probability" index="25" name="Probability of a broken leg"/>
    <alias field="coverage" index="26" name="Share seen"/>
    <alias field="score" index="27" name="Probability"/>
    <alias field="status" index="28" name="Status"/>
    <alias field="distance_median" index="29" name="Distance of the points [m]"/>
    <alias field="supported" index="30" name="Share supported"/>
    <alias field="nearest_centre" index="31" name="Nearest centre [m]"/>
    <alias field="overlap_share" index="32" name="Overlap"/>
    <alias field="may_be" index="33" name="May be"/>
  </aliases>
  <splitPolicies>
    <policy field="unit_id" policy="Duplicate"/>
    <policy field="epoch" policy="Duplicate"/>
    <policy field="epoch_time" policy="Duplicate"/>
    <policy field="epoch_until" policy="Duplicate"/>
    <policy field="unit_type" policy="Duplicate"/>
    <policy field="height" policy="Duplicate"/>
    <policy field="r0" policy="Duplicate"/>
    <policy field="gradient" policy="Duplicate"/>
    <policy field="qx" policy="Duplicate"/>
    <policy field="qy" policy="Duplicate"/>
    <policy field="qz" policy="Duplicate"/>
    <policy field="qw" policy="Duplicate"/>
    <policy field="sd_e" policy="Duplicate"/>
    <policy field="sd_n" policy="Duplicate"/>
    <policy field="sd_h" policy="Duplicate"/>
    <policy field="sd_rotation_deg" policy="Duplicate"/>
    <policy field="covariance" policy="Duplicate"/>
    <policy field="sigma0" policy="Duplicate"/>
    <policy field="n_points" policy="Duplicate"/>
    <policy field="legs_visible" policy="Duplicate"/>
    <policy field="leg1" policy="Duplicate"/>
    <policy field="leg2" policy="Duplicate"/>
    <policy field="leg3" policy="Duplicate"/>
    <policy field="leg4" policy="Duplicate"/>
    <policy field="leg_missing" policy="Duplicate"/>
    <policy field="leg_probability" policy="Duplicate"/>
    <policy field="coverage" policy="Duplicate"/>
    <policy field="score" policy="Duplicate"/>
    <policy field="status" policy="Duplicate"/>
    <policy field="distance_median" policy="Duplicate"/>
    <policy field="supported" policy="Duplicate"/>
    <policy field="nearest_centre" policy="Duplicate"/>
    <policy field="overlap_share" policy="Duplicate"/>
    <policy field="may_be" policy="Duplicate"/>
  </splitPolicies>
  <duplicatePolicies>
    <policy field="unit_id" policy="Duplicate"/>
    <policy field="epoch" policy="Duplicate"/>
    <policy field="epoch_time" policy="Duplicate"/>
    <policy field="epoch_until" policy="Duplicate"/>
    <policy field="unit_type" policy="Duplicate"/>
    <policy field="height" policy="Duplicate"/>
    <policy field="r0" policy="Duplicate"/>
    <policy field="gradient" policy="Duplicate"/>
    <policy field="qx" policy="Duplicate"/>
    <policy field="qy" policy="Duplicate"/>
    <policy field="qz" policy="Duplicate"/>
    <policy field="qw" policy="Duplicate"/>
    <policy field="sd_e" policy="Duplicate"/>
    <policy field="sd_n" policy="Duplicate"/>
    <policy field="sd_h" policy="Duplicate"/>
    <policy field="sd_rotation_deg" policy="Duplicate"/>
    <policy field="covariance" policy="Duplicate"/>
    <policy field="sigma0" policy="Duplicate"/>
    <policy field="n_points" policy="Duplicate"/>
    <policy field="legs_visible" policy="Duplicate"/>
    <policy field="leg1" policy="Duplicate"/>
    <policy field="leg2" policy="Duplicate"/>
    <policy field="leg3" policy="Duplicate"/>
    <policy field="leg4" policy="Duplicate"/>
    <policy field="leg_missing" policy="Duplicate"/>
    <policy field="leg_probability" policy="Duplicate"/>
    <policy field="coverage" policy="Duplicate"/>
    <policy field="score" policy="Duplicate"/>
    <policy field="status" policy="Duplicate"/>
    <policy field="distance_median" policy="Duplicate"/>
    <policy field="supported" policy="Duplicate"/>
    <policy field="nearest_centre" policy="Duplicate"/>
    <policy field="overlap_share" policy="Duplicate"/>
    <policy field="may_be" policy="Duplicate"/>
  </duplicatePolicies>
  <defaults>
    <default field="unit_id" expression="" applyOnUpdate="0"/>
    <default field="epoch" expression="" applyOnUpdate="0"/>
    <default field="epoch_time" expression="" applyOnUpdate="0"/>
    <default field="epoch_until" expression="" applyOnUpdate="0"/>
    <default field="unit_type" expression="" applyOnUpdate="0"/>
    <default field="height" expression="" applyOnUpdate="0"/>
    <default field="r0" expression="" applyOnUpdate="0"/>
    <default field="gradient" expression="" applyOnUpdate="0"/>
    <default field="qx" expression="" applyOnUpdate="0"/>
    <default field="qy" expression="" applyOnUpdate="0"/>
    <default field="qz" expression="" applyOnUpdate="0"/>
    <default field="qw" expression="" applyOnUpdate="0"/>
    <default field="sd_e" expression="" applyOnUpdate="0"/>
    <default field="sd_n" expression="" applyOnUpdate="0"/>
    <default field="sd_h" expression="" applyOnUpdate="0"/>
    <default field="sd_rotation_deg" expression="" applyOnUpdate="0"/>
    <default field="covariance" expression="" applyOnUpdate="0"/>
    <default field="sigma0" expression="" applyOnUpdate="0"/>
    <default field="n_points" expression="" applyOnUpdate="0"/>
    <default field="legs_visible" expression="" applyOnUpdate="0"/>
    <default field="leg1" expression="" applyOnUpdate="0"/>
    <default field="leg2" expression="" applyOnUpdate="0"/>
    <default field="leg3" expression="" applyOnUpdate="0"/>
    <default field="leg4" expression="" applyOnUpdate="0"/>
    <default field="leg_missing" expression="" applyOnUpdate="0"/>
    <default field="leg_probability" expression="" applyOnUpdate="0"/>
    <default field="coverage" expression="" applyOnUpdate="0"/>
    <default field="score" expression="" applyOnUpdate="0"/>
    <default field="status" expression="" applyOnUpdate="0"/>
    <default field="distance_median" expression="" applyOnUpdate="0"/>
    <default field="supported" expression="" applyOnUpdate="0"/>
    <default field="nearest_centre" expression="" applyOnUpdate="0"/>
    <default field="overlap_share" expression="" applyOnUpdate="0"/>
    <default field="may_be" expression="" applyOnUpdate="0"/>
  </defaults>
  <constraints>
    <constraint constraints="0" field="unit_id" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="epoch" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="epoch_time" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="epoch_until" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="unit_type" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="height" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="r0" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="gradient" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="qx" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="qy" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="qz" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="qw" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="sd_e" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="sd_n" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="sd_h" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="sd_rotation_deg" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="covariance" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="sigma0" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="n_points" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="legs_visible" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg1" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg2" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg3" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg4" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg_missing" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg_probability" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="coverage" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="score" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="status" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="distance_median" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="supported" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="nearest_centre" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="overlap_share" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="may_be" notnull_strength="0" unique_strength="0" exp_strength="0"/>
  </constraints>
  <constraintExpressions>
    <constraint field="unit_id" exp="" desc=""/>
    <constraint field="epoch" exp="" desc=""/>
    <constraint field="epoch_time" exp="" desc=""/>
    <constraint field="epoch_until" exp="" desc=""/>
    <constraint field="unit_type" exp="" desc=""/>
    <constraint field="height" exp="" desc=""/>
    <constraint field="r0" exp="" desc=""/>
    <constraint field="gradient" exp="" desc=""/>
    <constraint field="qx" exp="" desc=""/>
    <constraint field="qy" exp="" desc=""/>
    <constraint field="qz" exp="" desc=""/>
    <constraint field="qw" exp="" desc=""/>
    <constraint field="sd_e" exp="" desc=""/>
    <constraint field="sd_n" exp="" desc=""/>
    <constraint field="sd_h" exp="" desc=""/>
    <constraint field="sd_rotation_deg" exp="" desc=""/>
    <constraint field="covariance" exp="" desc=""/>
    <constraint field="sigma0" exp="" desc=""/>
    <constraint field="n_points" exp="" desc=""/>
    <constraint field="legs_visible" exp="" desc=""/>
    <constraint field="leg1" exp="" desc=""/>
    <constraint field="leg2" exp="" desc=""/>
    <constraint field="leg3" exp="" desc=""/>
    <constraint field="leg4" exp="" desc=""/>
    <constraint field="leg_missing" exp="" desc=""/>
    <constraint field="leg_probability" exp="" desc=""/>
    <constraint field="coverage" exp="" desc=""/>
    <constraint field="score" exp="" desc=""/>
    <constraint field="status" exp="" desc=""/>
    <constraint field="distance_median" exp="" desc=""/>
    <constraint field="supported" exp="" desc=""/>
    <constraint field="nearest_centre" exp="" desc=""/>
    <constraint field="overlap_share" exp="" desc=""/>
    <constraint field="may_be" exp="" desc=""/>
  </constraintExpressions>
  <expressionfields/>
  <attributetableconfig actionWidgetStyle="dropDown" sortExpression="" sortOrder="0">
    <columns>
      <column hidden="0" type="field" width="-1" name="unit_id"/>
      <column hidden="0" type="field" width="-1" name="epoch"/>
      <column hidden="0" type="field" width="-1" name="epoch_time"/>
      <column hidden="0" type="field" width="-1" name="epoch_until"/>
      <column hidden="0" type="field" width="-1" name="unit_type"/>
      <column hidden="0" type="field" width="-1" name="height"/>
      <column hidden="1" type="field" width="-1" name="r0"/>
      <column hidden="1" type="field" width="-1" name="gradient"/>
      <column hidden="1" type="field" width="-1" name="qx"/>
      <column hidden="1" type="field" width="-1" name="qy"/>
      <column hidden="1" type="field" width="-1" name="qz"/>
      <column hidden="1" type="field" width="-1" name="qw"/>
      <column hidden="0" type="field" width="-1" name="sd_e"/>
      <column hidden="0" type="field" width="-1" name="sd_n"/>
      <column hidden="0" type="field" width="-1" name="sd_h"/>
      <column hidden="0" type="field" width="-1" name="sd_rotation_deg"/>
      <column hidden="1" type="field" width="-1" name="covariance"/>
      <column hidden="0" type="field" width="-1" name="sigma0"/>
      <column hidden="0" type="field" width="-1" name="n_points"/>
      <column hidden="0" type="field" width="-1" name="legs_visible"/>
      <column hidden="0" type="field" width="-1" name="leg1"/>
      <column hidden="0" type="field" width="-1" name="leg2"/>
      <column hidden="0" type="field" width="-1" name="leg3"/>
      <column hidden="0" type="field" width="-1" name="leg4"/>
      <column hidden="0" type="field" width="-1" name="leg_missing"/>
      <column hidden="0" type="field" width="-1" name="leg_probability"/>
      <column hidden="0" type="field" width="-1" name="coverage"/>
      <column hidden="0" type="field" width="-1" name="score"/>
      <column hidden="0" type="field" width="-1" name="status"/>
      <column hidden="0" type="field" width="-1" name="distance_median"/>
      <column hidden="0" type="field" width="-1" name="supported"/>
      <column hidden="0" type="field" width="-1" name="nearest_centre"/>
      <column hidden="0" type="field" width="-1" name="overlap_share"/>
      <column hidden="0" type="field" width="-1" name="may_be"/>
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
  <mapTip enabled="1">&lt;b>[% "unit_id" %]&lt;/b> [% "epoch" %]&lt;br>[% "status" %], score [% round("score", 2) %]&lt;br>sd [% format_number(coalesce(@tetratrack_factor, 1)*("sd_e"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("sd_n"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("sd_h"), coalesce(@tetratrack_decimals, 3)) %] [% coalesce(@tetratrack_unit, 'm') %]</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
