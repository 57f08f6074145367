<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis simplifyMaxScale="1" styleCategories="Symbology|Symbology3D|Labeling|MapTips|Rendering|Temporal|Elevation" autoRefreshMode="Disabled" simplifyDrawingHints="1" simplifyLocal="1" simplifyDrawingTol="1" labelsEnabled="1" hasScaleBasedVisibilityFlag="0" autoRefreshTime="0" symbologyReferenceScale="-1" version="3.40.6-Bratislava" maxScale="0" simplifyAlgorithm="0" minScale="100000000">
  <renderer-3d layer="" type="vector">
    <vector-layer-3d-tiling show-bounding-boxes="0" zoom-levels-count="3"/>
    <symbol type="point" shape="sphere" material_type="phong">
      <data alt-clamping="absolute"/>
      <material opacity="1" kd="1" ks="1" specular="255,255,255,255,rgb:1,1,1,1" diffuse="22,133,127,255,rgb:0.08627450980392157,0.52156862745098043,0.49803921568627452,1" shininess="0" ambient="15,89,85,255,rgb:0.05751125352864881,0.34770733196002135,0.33203631647211412,1" ka="1">
        <data-defined-properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data-defined-properties>
      </material>
      <shape-properties>
        <Option type="Map">
          <Option value="" type="QString" name="model"/>
          <Option value="0.15" type="double" name="radius"/>
        </Option>
      </shape-properties>
      <transform matrix="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/>
      <symbol type="marker" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="symbol" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="SimpleMarker" locked="0" id="{f54104d9-a9e2-459a-9b94-f0634fd94cf8}">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="164,113,88,255,rgb:0.64313725490196083,0.44313725490196076,0.34509803921568627,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="circle" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="35,35,35,255,rgb:0.13725490196078433,0.13725490196078433,0.13725490196078433,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0" type="QString" name="outline_width"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="outline_width_map_unit_scale"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="diameter" type="QString" name="scale_method"/>
            <Option value="2" type="QString" name="size"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="size_map_unit_scale"/>
            <Option value="MM" type="QString" name="size_unit"/>
            <Option value="1" type="QString" name="vertical_anchor_point"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </symbol>
  </renderer-3d>
  <temporal endField="" endExpression="" fixedDuration="0" mode="1" enabled="1" durationField="" accumulate="0" limitMode="0" durationUnit="min" startField="epoch_time" startExpression="">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <elevation zoffset="0" respectLayerSymbol="1" type="IndividualFeatures" binding="Vertex" extrusionEnabled="0" showMarkerSymbolInSurfacePlots="1" clamping="Absolute" symbology="Line" extrusion="0" zscale="1">
    <data-defined-properties>
      <Option type="Map">
        <Option value="" type="QString" name="name"/>
        <Option name="properties"/>
        <Option value="collection" type="QString" name="type"/>
      </Option>
    </data-defined-properties>
    <profileLineSymbol>
      <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{72aa6712-b9f7-4544-8b9c-db971a17cf76}">
          <Option type="Map">
            <Option value="0" type="QString" name="align_dash_pattern"/>
            <Option value="square" type="QString" name="capstyle"/>
            <Option value="5;2" type="QString" name="customdash"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
            <Option value="MM" type="QString" name="customdash_unit"/>
            <Option value="0" type="QString" name="dash_pattern_offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
            <Option value="0" type="QString" name="draw_inside_polygon"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="114,155,111,255,rgb:0.44705882352941179,0.60784313725490191,0.43529411764705883,1" type="QString" name="line_color"/>
            <Option value="solid" type="QString" name="line_style"/>
            <Option value="0.6" type="QString" name="line_width"/>
            <Option value="MM" type="QString" name="line_width_unit"/>
            <Option value="0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="0" type="QString" name="ring_filter"/>
            <Option value="0" type="QString" name="trim_distance_end"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
            <Option value="MM" type="QString" name="trim_distance_end_unit"/>
            <Option value="0" type="QString" name="trim_distance_start"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
            <Option value="MM" type="QString" name="trim_distance_start_unit"/>
            <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
            <Option value="0" type="QString" name="use_custom_dash"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileLineSymbol>
    <profileFillSymbol>
      <symbol type="fill" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="SimpleFill" locked="0" id="{05425437-ea73-4efe-98b5-be262797c247}">
          <Option type="Map">
            <Option value="3x:0,0,0,0,0,0" type="QString" name="border_width_map_unit_scale"/>
            <Option value="114,155,111,255,rgb:0.44705882352941179,0.60784313725490191,0.43529411764705883,1" type="QString" name="color"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="81,111,79,255,rgb:0.31932555123216599,0.4341649500267033,0.3109178301670863,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0.2" type="QString" name="outline_width"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="solid" type="QString" name="style"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileFillSymbol>
    <profileMarkerSymbol>
      <symbol type="marker" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="SimpleMarker" locked="0" id="{963a31af-6f0e-40a8-be9a-19adc3ec105c}">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="114,155,111,255,rgb:0.44705882352941179,0.60784313725490191,0.43529411764705883,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="diamond" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="81,111,79,255,rgb:0.31932555123216599,0.4341649500267033,0.3109178301670863,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0.2" type="QString" name="outline_width"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="outline_width_map_unit_scale"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="diameter" type="QString" name="scale_method"/>
            <Option value="3" type="QString" name="size"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="size_map_unit_scale"/>
            <Option value="MM" type="QString" name="size_unit"/>
            <Option value="1" type="QString" name="vertical_anchor_point"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </profileMarkerSymbol>
  </elevation>
  <renderer-v2 type="RuleRenderer" forceraster="0" enableorderby="0" symbollevels="0" referencescale="-1">
    <rules key="{86de8422-ff47-491f-8e89-6c3d45d5177b}">
      <rule filter="&quot;status&quot; = 'found'" label="found" symbol="0" key="{b346c550-ae05-4c6a-b0f4-c82ccc659543}"/>
      <rule filter="&quot;status&quot; = 'uncertain'" label="uncertain" symbol="1" key="{ecdc04a3-6068-463f-8903-06ee99a0c987}"/>
      <rule filter="&quot;status&quot; = 'new'" label="new" symbol="2" key="{29f0592c-ba6b-4376-98b1-1fdd3f0872dc}"/>
      <rule filter="&quot;status&quot; = 'relocated'" label="relocated" symbol="3" key="{e0ecde23-49d6-45d9-9c4d-0fc9cbf31312}"/>
    </rules>
    <symbols>
      <symbol type="marker" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="0" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{4551abd6-4579-4017-b933-0e96b745f12f}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@0@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{93fa620a-f45b-46c2-b336-f434366d133d}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.8" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="180*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{e1715d3e-5165-46ba-9765-6e5c35870475}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@0@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{6b4a5ed6-c504-4be8-bde5-352c07bae34d}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="22,133,127,255,rgb:0.08627450980392157,0.52156862745098043,0.49803921568627452,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.2" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="120*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="SimpleMarker" locked="0" id="{5c0707a7-a0bf-47d7-885b-6b1a608fa2c6}">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="circle" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="22,133,127,255,rgb:0.08627450980392157,0.52156862745098043,0.49803921568627452,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0.3" type="QString" name="outline_width"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="outline_width_map_unit_scale"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="diameter" type="QString" name="scale_method"/>
            <Option value="1.4" type="QString" name="size"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="size_map_unit_scale"/>
            <Option value="MM" type="QString" name="size_unit"/>
            <Option value="1" type="QString" name="vertical_anchor_point"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol type="marker" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="1" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{08df8648-f720-45e3-9ded-113397a292cf}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@1@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{2991845f-f4b4-484e-8869-feb6a79fa7e9}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.8" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="180*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{15dc9773-ca02-4b13-9183-a75ca1d7e443}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@1@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{6ca81741-2e8c-4bfc-99e3-b1221ea69fd4}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="138,148,156,255,rgb:0.54117647058823526,0.58039215686274515,0.61176470588235299,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.2" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="120*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="SimpleMarker" locked="0" id="{0010b471-9de1-4a79-a68a-983e1a177e9f}">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="circle" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="138,148,156,255,rgb:0.54117647058823526,0.58039215686274515,0.61176470588235299,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0.3" type="QString" name="outline_width"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="outline_width_map_unit_scale"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="diameter" type="QString" name="scale_method"/>
            <Option value="1.4" type="QString" name="size"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="size_map_unit_scale"/>
            <Option value="MM" type="QString" name="size_unit"/>
            <Option value="1" type="QString" name="vertical_anchor_point"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol type="marker" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="2" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{d763dd6e-6a57-48a0-a345-2b13c99e6ea6}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@2@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{49635239-f41e-4f90-b524-9e01be0f2d71}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.8" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="180*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{adfffab0-6089-4be1-bdcc-6e65d9c7c306}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@2@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{7ad1c4fc-eb83-4beb-a0d2-7a9b08474ce9}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="47,143,78,255,rgb:0.18431372549019609,0.5607843137254902,0.30588235294117649,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.2" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="120*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="SimpleMarker" locked="0" id="{c48ec5e0-8d8d-45f3-b200-2953b53b9c2c}">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="circle" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="47,143,78,255,rgb:0.18431372549019609,0.5607843137254902,0.30588235294117649,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0.3" type="QString" name="outline_width"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="outline_width_map_unit_scale"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="diameter" type="QString" name="scale_method"/>
            <Option value="1.4" type="QString" name="size"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="size_map_unit_scale"/>
            <Option value="MM" type="QString" name="size_unit"/>
            <Option value="1" type="QString" name="vertical_anchor_point"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
      <symbol type="marker" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="3" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{e1f1fb45-73e2-4d6d-9478-1d4ba7912c49}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@3@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{13812cf8-b959-45b3-9503-e3d4624309d8}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.8" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="180*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="GeometryGenerator" locked="0" id="{f7a6391f-15a2-4e4c-a083-fb5d73e7e5c4}">
          <Option type="Map">
            <Option value="Line" type="QString" name="SymbolType"/>
            <Option value="collect_geometries(make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*1.0),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.0+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*1.0))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*0.942809+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.0+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*0.942809+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.0+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))),make_line(make_point($x,$y),make_point($x+0.644*&quot;height&quot;*((1-2*(&quot;qy&quot;^2+&quot;qz&quot;^2))*-0.471405+2*(&quot;qx&quot;*&quot;qy&quot;-&quot;qw&quot;*&quot;qz&quot;)*-0.816497+2*(&quot;qx&quot;*&quot;qz&quot;+&quot;qw&quot;*&quot;qy&quot;)*-0.333333),$y+0.644*&quot;height&quot;*(2*(&quot;qx&quot;*&quot;qy&quot;+&quot;qw&quot;*&quot;qz&quot;)*-0.471405+(1-2*(&quot;qx&quot;^2+&quot;qz&quot;^2))*-0.816497+2*(&quot;qy&quot;*&quot;qz&quot;-&quot;qw&quot;*&quot;qx&quot;)*-0.333333))))" type="QString" name="geometryModifier"/>
            <Option value="MapUnit" type="QString" name="units"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
          <symbol type="line" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="@3@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleLine" locked="0" id="{bd5ed39f-1d9f-4271-8aee-6e0d23a506b4}">
              <Option type="Map">
                <Option value="0" type="QString" name="align_dash_pattern"/>
                <Option value="round" type="QString" name="capstyle"/>
                <Option value="5;2" type="QString" name="customdash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="customdash_map_unit_scale"/>
                <Option value="MM" type="QString" name="customdash_unit"/>
                <Option value="0" type="QString" name="dash_pattern_offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="dash_pattern_offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="dash_pattern_offset_unit"/>
                <Option value="0" type="QString" name="draw_inside_polygon"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="123,63,160,255,rgb:0.4823529411764706,0.24705882352941178,0.62745098039215685,1" type="QString" name="line_color"/>
                <Option value="solid" type="QString" name="line_style"/>
                <Option value="1.2" type="QString" name="line_width"/>
                <Option value="MM" type="QString" name="line_width_unit"/>
                <Option value="0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="0" type="QString" name="ring_filter"/>
                <Option value="0" type="QString" name="trim_distance_end"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_end_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_end_unit"/>
                <Option value="0" type="QString" name="trim_distance_start"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="trim_distance_start_map_unit_scale"/>
                <Option value="MM" type="QString" name="trim_distance_start_unit"/>
                <Option value="0" type="QString" name="tweak_dash_pattern_on_corners"/>
                <Option value="0" type="QString" name="use_custom_dash"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="width_map_unit_scale"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option type="Map" name="properties">
                    <Option type="Map" name="outlineWidth">
                      <Option value="true" type="bool" name="active"/>
                      <Option value="120*&quot;height&quot;/@map_scale" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer pass="0" enabled="1" class="SimpleMarker" locked="0" id="{12e8d479-0465-4878-9b10-16544113fd84}">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="circle" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="123,63,160,255,rgb:0.4823529411764706,0.24705882352941178,0.62745098039215685,1" type="QString" name="outline_color"/>
            <Option value="solid" type="QString" name="outline_style"/>
            <Option value="0.3" type="QString" name="outline_width"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="outline_width_map_unit_scale"/>
            <Option value="MM" type="QString" name="outline_width_unit"/>
            <Option value="diameter" type="QString" name="scale_method"/>
            <Option value="1.4" type="QString" name="size"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="size_map_unit_scale"/>
            <Option value="MM" type="QString" name="size_unit"/>
            <Option value="1" type="QString" name="vertical_anchor_point"/>
          </Option>
          <data_defined_properties>
            <Option type="Map">
              <Option value="" type="QString" name="name"/>
              <Option name="properties"/>
              <Option value="collection" type="QString" name="type"/>
            </Option>
          </data_defined_properties>
        </layer>
      </symbol>
    </symbols>
    <data-defined-properties>
      <Option type="Map">
        <Option value="" type="QString" name="name"/>
        <Option name="properties"/>
        <Option value="collection" type="QString" name="type"/>
      </Option>
    </data-defined-properties>
  </renderer-v2>
  <selection mode="Default">
    <selectionColor invalid="1"/>
  </selection>
  <labeling type="simple">
    <settings calloutType="simple">
      <text-style multilineHeightUnit="Percentage" fontItalic="0" textColor="32,48,58,255,rgb:0.12549019607843137,0.18823529411764706,0.22745098039215686,1" isExpression="1" fontKerning="1" allowHtml="0" fontWordSpacing="0" fontSize="8" previewBkgrdColor="255,255,255,255,rgb:1,1,1,1" blendMode="0" forcedItalic="0" useSubstitutions="0" forcedBold="0" capitalization="0" multilineHeight="1" tabStopDistanceUnit="Percentage" fontStrikeout="0" namedStyle="" tabStopDistanceMapUnitScale="3x:0,0,0,0,0,0" fontLetterSpacing="0" tabStopDistance="6" legendString="Aa" fontWeight="50" textOrientation="horizontal" fontFamily="DejaVu LGC Sans" fontSizeUnit="Point" fontSizeMapUnitScale="3x:0,0,0,0,0,0" textOpacity="1" fontUnderline="0" fieldName="if((@map_start_time is not null or &quot;epoch_time&quot; = maximum(&quot;epoch_time&quot;)), &quot;unit_id&quot;, '')">
        <families/>
        <text-buffer bufferNoFill="1" bufferSize="0.69999999999999996" bufferSizeUnits="MM" bufferColor="255,255,255,255,rgb:1,1,1,1" bufferSizeMapUnitScale="3x:0,0,0,0,0,0" bufferJoinStyle="128" bufferOpacity="1" bufferBlendMode="0" bufferDraw="1"/>
        <text-mask maskType="0" maskOpacity="1" maskedSymbolLayers="" maskSize2="1.5" maskSizeUnits="MM" maskSize="1.5" maskJoinStyle="128" maskEnabled="0" maskSizeMapUnitScale="3x:0,0,0,0,0,0"/>
        <background shapeOffsetX="0" shapeBorderWidthMapUnitScale="3x:0,0,0,0,0,0" shapeRadiiUnit="MM" shapeOffsetY="0" shapeBorderColor="128,128,128,255,rgb:0.50196078431372548,0.50196078431372548,0.50196078431372548,1" shapeJoinStyle="64" shapeSizeX="0" shapeRotationType="0" shapeRadiiY="0" shapeSizeMapUnitScale="3x:0,0,0,0,0,0" shapeRotation="0" shapeRadiiX="0" shapeSizeType="0" shapeSVGFile="" shapeType="0" shapeSizeUnit="MM" shapeBlendMode="0" shapeDraw="0" shapeOffsetUnit="MM" shapeBorderWidthUnit="MM" shapeOpacity="1" shapeOffsetMapUnitScale="3x:0,0,0,0,0,0" shapeFillColor="255,255,255,255,rgb:1,1,1,1" shapeSizeY="0" shapeBorderWidth="0" shapeRadiiMapUnitScale="3x:0,0,0,0,0,0">
          <symbol type="fill" alpha="1" frame_rate="10" is_animated="0" clip_to_extent="1" name="fillSymbol" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer pass="0" enabled="1" class="SimpleFill" locked="0" id="">
              <Option type="Map">
                <Option value="3x:0,0,0,0,0,0" type="QString" name="border_width_map_unit_scale"/>
                <Option value="255,255,255,255,rgb:1,1,1,1" type="QString" name="color"/>
                <Option value="bevel" type="QString" name="joinstyle"/>
                <Option value="0,0" type="QString" name="offset"/>
                <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
                <Option value="MM" type="QString" name="offset_unit"/>
                <Option value="128,128,128,255,rgb:0.50196078431372548,0.50196078431372548,0.50196078431372548,1" type="QString" name="outline_color"/>
                <Option value="no" type="QString" name="outline_style"/>
                <Option value="0" type="QString" name="outline_width"/>
                <Option value="MM" type="QString" name="outline_width_unit"/>
                <Option value="solid" type="QString" name="style"/>
              </Option>
              <data_defined_properties>
                <Option type="Map">
                  <Option value="" type="QString" name="name"/>
                  <Option name="properties"/>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </background>
        <shadow shadowRadiusAlphaOnly="0" shadowOpacity="0.69999999999999996" shadowOffsetAngle="135" shadowRadius="1.5" shadowOffsetDist="1" shadowOffsetGlobal="1" shadowRadiusMapUnitScale="3x:0,0,0,0,0,0" shadowScale="100" shadowBlendMode="6" shadowOffsetUnit="MM" shadowOffsetMapUnitScale="3x:0,0,0,0,0,0" shadowColor="0,0,0,255,rgb:0,0,0,1" shadowDraw="0" shadowUnder="0" shadowRadiusUnit="MM"/>
        <dd_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </dd_properties>
        <substitutions/>
      </text-style>
      <text-format placeDirectionSymbol="0" autoWrapLength="0" useMaxLineLengthForAutoWrap="1" addDirectionSymbol="0" reverseDirectionSymbol="0" rightDirectionSymbol=">" wrapChar="" formatNumbers="0" decimals="3" plussign="0" leftDirectionSymbol="&lt;" multilineAlign="3"/>
      <placement maxCurvedCharAngleOut="-25" repeatDistanceMapUnitScale="3x:0,0,0,0,0,0" rotationUnit="AngleDegrees" maximumDistance="0" placementFlags="10" maximumDistanceUnit="MM" priority="5" preserveRotation="1" maximumDistanceMapUnitScale="3x:0,0,0,0,0,0" quadOffset="4" fitInPolygonOnly="0" polygonPlacementFlags="2" prioritization="PreferCloser" offsetUnits="MM" allowDegraded="0" overrunDistanceUnit="MM" maxCurvedCharAngleIn="25" lineAnchorTextPoint="FollowPlacement" centroidInside="0" offsetType="0" overlapHandling="PreventOverlap" geometryGeneratorEnabled="0" dist="0" overrunDistance="0" geometryGenerator="" lineAnchorType="0" xOffset="0" lineAnchorPercent="0.5" labelOffsetMapUnitScale="3x:0,0,0,0,0,0" rotationAngle="0" distUnits="MM" overrunDistanceMapUnitScale="3x:0,0,0,0,0,0" repeatDistanceUnits="MM" lineAnchorClipping="0" layerType="UnknownGeometry" centroidWhole="0" predefinedPositionOrder="TR,TL,BR,BL,R,L,TSR,BSR" yOffset="0" distMapUnitScale="3x:0,0,0,0,0,0" repeatDistance="0" placement="0" geometryGeneratorType="PointGeometry"/>
      <rendering fontMinPixelSize="0" scaleMin="0" upsidedownLabels="0" minFeatureSize="0" obstacle="1" drawLabels="1" obstacleFactor="1" labelPerPart="0" limitNumLabels="0" scaleVisibility="1" maxNumLabels="2000" scaleMax="300" mergeLines="0" unplacedVisibility="0" obstacleType="1" fontMaxPixelSize="10000" zIndex="0" fontLimitPixelSize="0"/>
      <dd_properties>
        <Option type="Map">
          <Option value="" type="QString" name="name"/>
          <Option name="properties"/>
          <Option value="collection" type="QString" name="type"/>
        </Option>
      </dd_properties>
      <callout type="simple">
        <Option type="Map">
          <Option value="pole_of_inaccessibility" type="QString" name="anchorPoint"/>
          <Option value="0" type="int" name="blendMode"/>
          <Option type="Map" name="ddProperties">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
          <Option value="false" type="bool" name="drawToAllParts"/>
          <Option value="0" type="QString" name="enabled"/>
          <Option value="point_on_exterior" type="QString" name="labelAnchorPoint"/>
          <Option value="&lt;symbol type=&quot;line&quot; alpha=&quot;1&quot; frame_rate=&quot;10&quot; is_animated=&quot;0&quot; clip_to_extent=&quot;1&quot; name=&quot;symbol&quot; force_rhr=&quot;0&quot;>&lt;data_defined_properties>&lt;Option type=&quot;Map&quot;>&lt;Option value=&quot;&quot; type=&quot;QString&quot; name=&quot;name&quot;/>&lt;Option name=&quot;properties&quot;/>&lt;Option value=&quot;collection&quot; type=&quot;QString&quot; name=&quot;type&quot;/>&lt;/Option>&lt;/data_defined_properties>&lt;layer pass=&quot;0&quot; enabled=&quot;1&quot; class=&quot;SimpleLine&quot; locked=&quot;0&quot; id=&quot;{908d1990-21a1-4ae0-83f1-036cbd32b47b}&quot;>&lt;Option type=&quot;Map&quot;>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;align_dash_pattern&quot;/>&lt;Option value=&quot;square&quot; type=&quot;QString&quot; name=&quot;capstyle&quot;/>&lt;Option value=&quot;5;2&quot; type=&quot;QString&quot; name=&quot;customdash&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;customdash_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;customdash_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;dash_pattern_offset&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;dash_pattern_offset_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;dash_pattern_offset_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;draw_inside_polygon&quot;/>&lt;Option value=&quot;bevel&quot; type=&quot;QString&quot; name=&quot;joinstyle&quot;/>&lt;Option value=&quot;60,60,60,255,rgb:0.23529411764705882,0.23529411764705882,0.23529411764705882,1&quot; type=&quot;QString&quot; name=&quot;line_color&quot;/>&lt;Option value=&quot;solid&quot; type=&quot;QString&quot; name=&quot;line_style&quot;/>&lt;Option value=&quot;0.3&quot; type=&quot;QString&quot; name=&quot;line_width&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;line_width_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;offset&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;offset_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;offset_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;ring_filter&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;trim_distance_end&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;trim_distance_end_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;trim_distance_end_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;trim_distance_start&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;trim_distance_start_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;trim_distance_start_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;tweak_dash_pattern_on_corners&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;use_custom_dash&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;width_map_unit_scale&quot;/>&lt;/Option>&lt;data_defined_properties>&lt;Option type=&quot;Map&quot;>&lt;Option value=&quot;&quot; type=&quot;QString&quot; name=&quot;name&quot;/>&lt;Option name=&quot;properties&quot;/>&lt;Option value=&quot;collection&quot; type=&quot;QString&quot; name=&quot;type&quot;/>&lt;/Option>&lt;/data_defined_properties>&lt;/layer>&lt;/symbol>" type="QString" name="lineSymbol"/>
          <Option value="0" type="double" name="minLength"/>
          <Option value="3x:0,0,0,0,0,0" type="QString" name="minLengthMapUnitScale"/>
          <Option value="MM" type="QString" name="minLengthUnit"/>
          <Option value="0" type="double" name="offsetFromAnchor"/>
          <Option value="3x:0,0,0,0,0,0" type="QString" name="offsetFromAnchorMapUnitScale"/>
          <Option value="MM" type="QString" name="offsetFromAnchorUnit"/>
          <Option value="0" type="double" name="offsetFromLabel"/>
          <Option value="3x:0,0,0,0,0,0" type="QString" name="offsetFromLabelMapUnitScale"/>
          <Option value="MM" type="QString" name="offsetFromLabelUnit"/>
        </Option>
      </callout>
    </settings>
  </labeling>
  <blendMode>0</blendMode>
  <featureBlendMode>0</featureBlendMode>
  <layerOpacity>1</layerOpacity>
  <mapTip enabled="1">&lt;b>[% "unit_id" %]&lt;/b> [% "epoch" %]&lt;br>[% "status" %], score [% round("score", 2) %]&lt;br>sd [% round(1000*"sd_e",1) %] / [% round(1000*"sd_n",1) %] / [% round(1000*"sd_h",1) %] mm</mapTip>
  <layerGeometryType>0</layerGeometryType>
</qgis>
