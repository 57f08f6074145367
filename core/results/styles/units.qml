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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{8179b7df-6198-458a-9ab3-c2fd89216fe1}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1"/>
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
        <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{15b83309-faf0-4929-b834-01c85c6e203e}">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleFill" id="{6db6ef9a-1545-4100-96c9-8dff2d1e0684}">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{37d8a88c-8a48-418f-9eb7-6a716f868042}">
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
    <rules key="{95a92b33-f701-4b62-8956-1be6643fcfe5}">
      <rule filter="&quot;status&quot; = 'found' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="0" key="{cc30a8e9-9328-4be9-82e1-507b5e123972}" label="found"/>
      <rule filter="&quot;status&quot; = 'uncertain' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="1" key="{38907ed6-af3f-4c4a-8363-4c792e5370c5}" label="uncertain"/>
      <rule filter="&quot;status&quot; = 'new' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="2" key="{76bb0b15-f11f-4008-b846-598904957bfb}" label="new"/>
      <rule filter="&quot;status&quot; = 'relocated' and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="3" key="{a29c5fee-3838-4e29-9bd2-2278fe70c429}" label="relocated"/>
      <rule filter="'broken' in (&quot;leg1&quot;, &quot;leg2&quot;, &quot;leg3&quot;, &quot;leg4&quot;) and (@map_start_time is not null or &quot;epoch_until&quot; is null)" symbol="4" key="{9bd64424-2738-4f97-ab0f-f30a7f87d53f}" label="missing end of a broken leg"/>
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{bb2c1431-47ef-4cbd-b7bd-682626c0f8df}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{5af9a2cb-ffaf-45b1-8b45-adfd575c591e}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{2b3ba601-d490-43bd-9c53-a233cb807386}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{86087047-1ca6-493b-879b-f9dfae29424c}">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{bdce0b2a-e00f-4f6c-ba39-d51324096736}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{e28e89a5-ef9b-4baf-954e-98b3a0f4ec14}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{767f0402-c7d9-48ba-ac01-56819c4af72b}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{7d27c0c4-8bc5-470a-9a33-cd3d57e37c0e}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{6f248763-52d8-4392-81cc-e95f7a92973b}">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{c6d115c2-ebb2-4aec-b335-3bcdb560eee0}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{3a9f123f-df4b-4844-a1ad-54ea314e94b8}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{f55403e8-991d-4ae1-81c3-71cd8dcdbe30}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{1736d6a7-366f-462f-a2bf-36530661958e}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{042e5a18-168a-42fd-ba54-4cc6a4b07d47}">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{14fafc5b-842d-4e5c-9f9b-be6d7c68a718}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{44e2e81e-53c0-439d-8582-06f7f28a2496}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{48bae81a-b7f1-4b47-8b4e-9312f677d582}">
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{335f013c-e0fa-4c76-afcb-4d00b1b3cb35}">
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
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{5221fe81-d18a-4320-9ea7-65fc5d63e586}">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{f5cf09e7-602d-47cc-9cda-aa3819524cd0}">
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
      <symbol clip_to_extent="1" type="marker" name="4" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option type="QString" name="name" value=""/>
            <Option name="properties"/>
            <Option type="QString" name="type" value="collection"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{5a345903-0dc5-4d0a-9cc2-5b504b41c16b}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(array_filter(array(if(&quot;leg1&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg1_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+(0.644*&quot;height&quot;-&quot;leg1_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))), NULL),if(&quot;leg2&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg2_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+(0.644*&quot;height&quot;-&quot;leg2_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))), NULL),if(&quot;leg3&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg3_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+(0.644*&quot;height&quot;-&quot;leg3_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))), NULL),if(&quot;leg4&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg4_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+(0.644*&quot;height&quot;-&quot;leg4_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))), NULL)), @element is not null))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@4@0" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{31a307b7-b7dd-40d0-a6cd-dbe1df9e8d67}">
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
                <Option type="QString" name="line_color" value="255,255,255,255,rgb:1,1,1,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="1.2"/>
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
        <layer pass="0" locked="0" enabled="1" class="GeometryGenerator" id="{3d085eae-1400-4580-85f6-bb1be5fea320}">
          <Option type="Map">
            <Option type="QString" name="SymbolType" value="Line"/>
            <Option type="QString" name="geometryModifier" value="collect_geometries(array_filter(array(if(&quot;leg1&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg1_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+(0.644*&quot;height&quot;-&quot;leg1_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))), NULL),if(&quot;leg2&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg2_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+(0.644*&quot;height&quot;-&quot;leg2_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))), NULL),if(&quot;leg3&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg3_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+(0.644*&quot;height&quot;-&quot;leg3_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))), NULL),if(&quot;leg4&quot; = 'broken', make_line(make_point($x+(0.644*&quot;height&quot;-&quot;leg4_missing&quot;)*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+(0.644*&quot;height&quot;-&quot;leg4_missing&quot;)*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333)),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))), NULL)), @element is not null))"/>
            <Option type="QString" name="units" value="MapUnit"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option type="QString" name="name" value=""/>
              <Option name="properties"/>
              <Option type="QString" name="type" value="collection"/>
            </Option>
          </data_defined_properties>
          <symbol clip_to_extent="1" type="line" name="@4@1" is_animated="0" alpha="1" frame_rate="10" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option type="QString" name="name" value=""/>
                <Option name="properties"/>
                <Option type="QString" name="type" value="collection"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{230004d8-c67f-40ac-ade4-278c4e9ac27f}">
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
                <Option type="QString" name="line_color" value="198,40,40,255,rgb:0.77647058823529413,0.15686274509803921,0.15686274509803921,1"/>
                <Option type="QString" name="line_style" value="solid"/>
                <Option type="QString" name="line_width" value="0.8"/>
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
    <field configurationFlags="NoFlag" name="leg1_missing">
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
    <field configurationFlags="NoFlag" name="leg2_missing">
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
    <field configurationFlags="NoFlag" name="leg3_missing">
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
    <field configurationFlags="NoFlag" name="leg4_missing">
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
    <field configurationFlags="NoFlag" name="leg1_probability">
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
    <field configurationFlags="NoFlag" name="leg2_probability">
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
    <field configurationFlags="NoFlag" name="leg3_probability">
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
    <field configurationFlags="NoFlag" name="leg4_probability">
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
    <field configurationFlags="NoFlag" name="datum">
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
    <alias field="leg1_missing" index="26" name="Leg 1: missing [m]"/>
    <alias field="leg2_missing" index="27" name="Leg 2: missing [m]"/>
    <alias field="leg3_missing" index="28" name="Leg 3: missing [m]"/>
    <alias field="leg4_missing" index="29" name="Leg 4: missing [m]"/>
    <alias field="leg1_probability" index="30" name="Leg 1: probability of a break"/>
    <alias field="leg2_probability" index="31" name="Leg 2: probability of a break"/>
    <alias field="leg3_probability" index="32" name="Leg 3: probability of a break"/>
    <alias field="leg4_probability" index="33" name="Leg 4: probability of a break"/>
    <alias field="coverage" index="34" name="Share seen"/>
    <alias field="score" index="35" name="Probability"/>
    <alias field="status" index="36" name="Status"/>
    <alias field="datum" index="37" name="Datum"/>
    <alias field="distance_median" index="38" name="Distance of the points [m]"/>
    <alias field="supported" index="39" name="Share supported"/>
    <alias field="nearest_centre" index="40" name="Nearest centre [m]"/>
    <alias field="overlap_share" index="41" name="Overlap"/>
    <alias field="may_be" index="42" name="May be"/>
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
    <policy field="leg1_missing" policy="Duplicate"/>
    <policy field="leg2_missing" policy="Duplicate"/>
    <policy field="leg3_missing" policy="Duplicate"/>
    <policy field="leg4_missing" policy="Duplicate"/>
    <policy field="leg1_probability" policy="Duplicate"/>
    <policy field="leg2_probability" policy="Duplicate"/>
    <policy field="leg3_probability" policy="Duplicate"/>
    <policy field="leg4_probability" policy="Duplicate"/>
    <policy field="coverage" policy="Duplicate"/>
    <policy field="score" policy="Duplicate"/>
    <policy field="status" policy="Duplicate"/>
    <policy field="datum" policy="Duplicate"/>
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
    <policy field="leg1_missing" policy="Duplicate"/>
    <policy field="leg2_missing" policy="Duplicate"/>
    <policy field="leg3_missing" policy="Duplicate"/>
    <policy field="leg4_missing" policy="Duplicate"/>
    <policy field="leg1_probability" policy="Duplicate"/>
    <policy field="leg2_probability" policy="Duplicate"/>
    <policy field="leg3_probability" policy="Duplicate"/>
    <policy field="leg4_probability" policy="Duplicate"/>
    <policy field="coverage" policy="Duplicate"/>
    <policy field="score" policy="Duplicate"/>
    <policy field="status" policy="Duplicate"/>
    <policy field="datum" policy="Duplicate"/>
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
    <default field="leg1_missing" expression="" applyOnUpdate="0"/>
    <default field="leg2_missing" expression="" applyOnUpdate="0"/>
    <default field="leg3_missing" expression="" applyOnUpdate="0"/>
    <default field="leg4_missing" expression="" applyOnUpdate="0"/>
    <default field="leg1_probability" expression="" applyOnUpdate="0"/>
    <default field="leg2_probability" expression="" applyOnUpdate="0"/>
    <default field="leg3_probability" expression="" applyOnUpdate="0"/>
    <default field="leg4_probability" expression="" applyOnUpdate="0"/>
    <default field="coverage" expression="" applyOnUpdate="0"/>
    <default field="score" expression="" applyOnUpdate="0"/>
    <default field="status" expression="" applyOnUpdate="0"/>
    <default field="datum" expression="" applyOnUpdate="0"/>
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
    <constraint constraints="0" field="leg1_missing" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg2_missing" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg3_missing" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg4_missing" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg1_probability" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg2_probability" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg3_probability" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="leg4_probability" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="coverage" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="score" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="status" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="datum" notnull_strength="0" unique_strength="0" exp_strength="0"/>
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
    <constraint field="leg1_missing" exp="" desc=""/>
    <constraint field="leg2_missing" exp="" desc=""/>
    <constraint field="leg3_missing" exp="" desc=""/>
    <constraint field="leg4_missing" exp="" desc=""/>
    <constraint field="leg1_probability" exp="" desc=""/>
    <constraint field="leg2_probability" exp="" desc=""/>
    <constraint field="leg3_probability" exp="" desc=""/>
    <constraint field="leg4_probability" exp="" desc=""/>
    <constraint field="coverage" exp="" desc=""/>
    <constraint field="score" exp="" desc=""/>
    <constraint field="status" exp="" desc=""/>
    <constraint field="datum" exp="" desc=""/>
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
      <column hidden="0" type="field" width="-1" name="leg1_missing"/>
      <column hidden="0" type="field" width="-1" name="leg2_missing"/>
      <column hidden="0" type="field" width="-1" name="leg3_missing"/>
      <column hidden="0" type="field" width="-1" name="leg4_missing"/>
      <column hidden="0" type="field" width="-1" name="leg1_probability"/>
      <column hidden="0" type="field" width="-1" name="leg2_probability"/>
      <column hidden="0" type="field" width="-1" name="leg3_probability"/>
      <column hidden="0" type="field" width="-1" name="leg4_probability"/>
      <column hidden="0" type="field" width="-1" name="coverage"/>
      <column hidden="0" type="field" width="-1" name="score"/>
      <column hidden="0" type="field" width="-1" name="status"/>
      <column hidden="0" type="field" width="-1" name="datum"/>
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
  <mapTip enabled="1">&lt;b>[% "unit_id" %]&lt;/b> [% "epoch" %]&lt;br>[% "status" %], score [% round("score", 2) %]&lt;br>sd [% format_number(coalesce(@tetratrack_factor, 1)*("sd_e"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("sd_n"), coalesce(@tetratrack_decimals, 3)) %] / [% format_number(coalesce(@tetratrack_factor, 1)*("sd_h"), coalesce(@tetratrack_decimals, 3)) %] [% coalesce(@tetratrack_unit, 'm') %]&lt;br>[% array_to_string(array_filter(array(if(attribute('leg1') = 'broken', 'leg 1 broken' || coalesce(', ' || format_number(coalesce(@tetratrack_factor, 1)*(attribute('leg1_missing')), coalesce(@tetratrack_decimals, 3)) || ' ' || coalesce(@tetratrack_unit, 'm') || ' missing', '') || coalesce(' (' || round(100*attribute('leg1_probability')) || ' %)', ''), NULL),if(attribute('leg1') = 'unseen', 'end of leg 1 not seen', NULL),if(attribute('leg2') = 'broken', 'leg 2 broken' || coalesce(', ' || format_number(coalesce(@tetratrack_factor, 1)*(attribute('leg2_missing')), coalesce(@tetratrack_decimals, 3)) || ' ' || coalesce(@tetratrack_unit, 'm') || ' missing', '') || coalesce(' (' || round(100*attribute('leg2_probability')) || ' %)', ''), NULL),if(attribute('leg2') = 'unseen', 'end of leg 2 not seen', NULL),if(attribute('leg3') = 'broken', 'leg 3 broken' || coalesce(', ' || format_number(coalesce(@tetratrack_factor, 1)*(attribute('leg3_missing')), coalesce(@tetratrack_decimals, 3)) || ' ' || coalesce(@tetratrack_unit, 'm') || ' missing', '') || coalesce(' (' || round(100*attribute('leg3_probability')) || ' %)', ''), NULL),if(attribute('leg3') = 'unseen', 'end of leg 3 not seen', NULL),if(attribute('leg4') = 'broken', 'leg 4 broken' || coalesce(', ' || format_number(coalesce(@tetratrack_factor, 1)*(attribute('leg4_missing')), coalesce(@tetratrack_decimals, 3)) || ' ' || coalesce(@tetratrack_unit, 'm') || ' missing', '') || coalesce(' (' || round(100*attribute('leg4_probability')) || ' %)', ''), NULL),if(attribute('leg4') = 'unseen', 'end of leg 4 not seen', NULL)), @element is not null), '&lt;br>') %]</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
