<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis autoRefreshTime="0" simplifyDrawingHints="1" simplifyAlgorithm="0" simplifyDrawingTol="1" simplifyMaxScale="1" styleCategories="Symbology|Symbology3D|Labeling|MapTips|Rendering|Temporal|Elevation" hasScaleBasedVisibilityFlag="0" maxScale="0" labelsEnabled="1" symbologyReferenceScale="-1" simplifyLocal="1" autoRefreshMode="Disabled" minScale="100000000" version="3.40.6-Bratislava">
  <renderer-3d type="vector" layer="">
    <vector-layer-3d-tiling zoom-levels-count="3" show-bounding-boxes="0"/>
    <symbol material_type="phong" type="point" shape="sphere">
      <data alt-clamping="absolute"/>
      <material ambient="15,89,85,255,rgb:0.05751125352864881,0.34770733196002135,0.33203631647211412,1" specular="255,255,255,255,rgb:1,1,1,1" opacity="1" ks="1" diffuse="22,133,127,255,rgb:0.08627450980392157,0.52156862745098043,0.49803921568627452,1" shininess="0" kd="1" ka="1">
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
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="marker" name="symbol" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="SimpleMarker" pass="0" locked="0" id="{59c8b6d1-7f3e-4cb6-b3b1-acfae38f5120}" enabled="1">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="243,166,178,255,rgb:0.95294117647058818,0.65098039215686276,0.69803921568627447,1" type="QString" name="color"/>
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
  <temporal startField="epoch_time" startExpression="" accumulate="0" endField="" durationUnit="min" fixedDuration="0" endExpression="" durationField="" limitMode="0" mode="1" enabled="1">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <elevation showMarkerSymbolInSurfacePlots="1" symbology="Line" extrusionEnabled="0" extrusion="0" zoffset="0" clamping="Absolute" binding="Vertex" type="IndividualFeatures" respectLayerSymbol="1" zscale="1">
    <data-defined-properties>
      <Option type="Map">
        <Option value="" type="QString" name="name"/>
        <Option name="properties"/>
        <Option value="collection" type="QString" name="type"/>
      </Option>
    </data-defined-properties>
    <profileLineSymbol>
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="SimpleLine" pass="0" locked="0" id="{ac7a87d6-a14a-4584-8fe7-7d36bfd794f9}" enabled="1">
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
            <Option value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1" type="QString" name="line_color"/>
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
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="fill" name="" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="SimpleFill" pass="0" locked="0" id="{17e5c822-4c10-45b5-b57c-e5f65c3fa9c7}" enabled="1">
          <Option type="Map">
            <Option value="3x:0,0,0,0,0,0" type="QString" name="border_width_map_unit_scale"/>
            <Option value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1" type="QString" name="color"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="166,81,101,255,rgb:0.64985122453650723,0.31651789120317386,0.39496452277409017,1" type="QString" name="outline_color"/>
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
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="marker" name="" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="SimpleMarker" pass="0" locked="0" id="{752baebf-c72a-435d-b519-a4740270c763}" enabled="1">
          <Option type="Map">
            <Option value="0" type="QString" name="angle"/>
            <Option value="square" type="QString" name="cap_style"/>
            <Option value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1" type="QString" name="color"/>
            <Option value="1" type="QString" name="horizontal_anchor_point"/>
            <Option value="bevel" type="QString" name="joinstyle"/>
            <Option value="diamond" type="QString" name="name"/>
            <Option value="0,0" type="QString" name="offset"/>
            <Option value="3x:0,0,0,0,0,0" type="QString" name="offset_map_unit_scale"/>
            <Option value="MM" type="QString" name="offset_unit"/>
            <Option value="166,81,101,255,rgb:0.64985122453650723,0.31651789120317386,0.39496452277409017,1" type="QString" name="outline_color"/>
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
  <renderer-v2 symbollevels="0" forceraster="0" enableorderby="0" type="RuleRenderer" referencescale="-1">
    <rules key="{ab5491fa-3049-4144-bb6e-5187855d3ac7}">
      <rule symbol="0" label="found" filter="&quot;status&quot; = 'found'" key="{988c5c0d-a784-47d5-8a4e-6d2e70d29095}"/>
      <rule symbol="1" label="uncertain" filter="&quot;status&quot; = 'uncertain'" key="{a741429e-14bf-4bb6-a42d-418ce025df96}"/>
      <rule symbol="2" label="new" filter="&quot;status&quot; = 'new'" key="{f4ffbda1-e3dc-4071-939a-92f18a87f888}"/>
      <rule symbol="3" label="relocated" filter="&quot;status&quot; = 'relocated'" key="{fd6a2634-9a84-48a0-889d-aac0931811a1}"/>
    </rules>
    <symbols>
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="0.75" type="marker" name="0" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{21dd65d9-483e-417f-b63c-8b3efe0d3b5a}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@0@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{79e9a26d-b987-4ca6-9e75-f0d285ba128e}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.477*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{55992ee5-10d5-4f50-8682-2653687ff408}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@0@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{a6942953-5c06-4a13-8f37-2b9e062a06a7}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.415*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="SimpleMarker" pass="0" locked="0" id="{6416e59d-864c-4eb1-99f8-d70d5edb26bb}" enabled="1">
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
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="0.75" type="marker" name="1" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{c8ded72d-a61c-4a3f-8575-6159df847050}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@1@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{b368bcfd-bfc7-4687-9b4e-4c45e9a353af}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.477*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{5b4f4aa0-609e-4aed-9041-4b0e55ec4e41}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@1@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{be53424e-beb4-4c76-a5fb-bf6c7b4c8a7f}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.415*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="SimpleMarker" pass="0" locked="0" id="{fd471774-ee10-47ca-81fb-f501111e7460}" enabled="1">
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
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="0.75" type="marker" name="2" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{faf4731c-a713-4481-b44a-4d2f182c4013}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@2@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{4e11482c-0230-4dd4-83e6-96285e3b9430}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.477*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{e241507a-1cc6-46df-b3ae-5d7728a32382}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@2@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{eb77d7ab-057c-4ee6-b842-f53b834ef6e6}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.415*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="SimpleMarker" pass="0" locked="0" id="{bc5234a1-ee5b-4ea4-8dbb-110e3bf3e34a}" enabled="1">
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
      <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="0.75" type="marker" name="3" force_rhr="0">
        <data_defined_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </data_defined_properties>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{e88bedf3-aef6-4ac5-9e16-3f0be91eb03e}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@3@0" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{a6914586-0e95-4f9e-a622-a5daec557938}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.477*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="GeometryGenerator" pass="0" locked="0" id="{fa061890-3e87-43fd-9408-0a26a15d1084}" enabled="1">
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
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="line" name="@3@1" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleLine" pass="0" locked="0" id="{f7a93324-501e-40c3-b1c3-cdf76db7ca6b}" enabled="1">
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
                <Option value="1" type="QString" name="line_width"/>
                <Option value="MapUnit" type="QString" name="line_width_unit"/>
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
                      <Option value="0.415*&quot;height&quot;" type="QString" name="expression"/>
                      <Option value="3" type="int" name="type"/>
                    </Option>
                  </Option>
                  <Option value="collection" type="QString" name="type"/>
                </Option>
              </data_defined_properties>
            </layer>
          </symbol>
        </layer>
        <layer class="SimpleMarker" pass="0" locked="0" id="{8e7bb29d-cb1c-4a7f-8503-73809e3924e3}" enabled="1">
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
      <text-style allowHtml="0" fontFamily="DejaVu LGC Sans" fontLetterSpacing="0" fontSizeMapUnitScale="3x:0,0,0,0,0,0" tabStopDistanceUnit="Percentage" fontSizeUnit="Point" textOrientation="horizontal" fontSize="8" textColor="32,48,58,255,rgb:0.12549019607843137,0.18823529411764706,0.22745098039215686,1" forcedItalic="0" useSubstitutions="0" tabStopDistance="6" forcedBold="0" fontStrikeout="0" fontWordSpacing="0" fontUnderline="0" tabStopDistanceMapUnitScale="3x:0,0,0,0,0,0" isExpression="1" multilineHeight="1" textOpacity="1" blendMode="0" fontWeight="50" fontItalic="0" previewBkgrdColor="255,255,255,255,rgb:1,1,1,1" fieldName="&quot;unit_id&quot;" fontKerning="1" namedStyle="" multilineHeightUnit="Percentage" capitalization="0" legendString="Aa">
        <families/>
        <text-buffer bufferNoFill="1" bufferOpacity="1" bufferDraw="1" bufferSizeUnits="MM" bufferSizeMapUnitScale="3x:0,0,0,0,0,0" bufferColor="255,255,255,255,rgb:1,1,1,1" bufferJoinStyle="128" bufferBlendMode="0" bufferSize="0.69999999999999996"/>
        <text-mask maskSize2="1.5" maskSize="1.5" maskOpacity="1" maskSizeMapUnitScale="3x:0,0,0,0,0,0" maskedSymbolLayers="" maskType="0" maskEnabled="0" maskSizeUnits="MM" maskJoinStyle="128"/>
        <background shapeBorderWidth="0" shapeBorderWidthMapUnitScale="3x:0,0,0,0,0,0" shapeSizeType="0" shapeDraw="0" shapeOffsetUnit="MM" shapeType="0" shapeSVGFile="" shapeBorderColor="128,128,128,255,rgb:0.50196078431372548,0.50196078431372548,0.50196078431372548,1" shapeRadiiY="0" shapeRadiiX="0" shapeRotationType="0" shapeSizeX="0" shapeBlendMode="0" shapeOffsetY="0" shapeOpacity="1" shapeSizeUnit="MM" shapeOffsetX="0" shapeRadiiMapUnitScale="3x:0,0,0,0,0,0" shapeRadiiUnit="MM" shapeOffsetMapUnitScale="3x:0,0,0,0,0,0" shapeSizeY="0" shapeRotation="0" shapeJoinStyle="64" shapeSizeMapUnitScale="3x:0,0,0,0,0,0" shapeFillColor="255,255,255,255,rgb:1,1,1,1" shapeBorderWidthUnit="MM">
          <symbol is_animated="0" frame_rate="10" clip_to_extent="1" alpha="1" type="fill" name="fillSymbol" force_rhr="0">
            <data_defined_properties>
              <Option type="Map">
                <Option value="" type="QString" name="name"/>
                <Option name="properties"/>
                <Option value="collection" type="QString" name="type"/>
              </Option>
            </data_defined_properties>
            <layer class="SimpleFill" pass="0" locked="0" id="" enabled="1">
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
        <shadow shadowOffsetDist="1" shadowOffsetUnit="MM" shadowOpacity="0.69999999999999996" shadowBlendMode="6" shadowUnder="0" shadowOffsetMapUnitScale="3x:0,0,0,0,0,0" shadowDraw="0" shadowOffsetAngle="135" shadowOffsetGlobal="1" shadowRadius="1.5" shadowRadiusUnit="MM" shadowRadiusMapUnitScale="3x:0,0,0,0,0,0" shadowScale="100" shadowColor="0,0,0,255,rgb:0,0,0,1" shadowRadiusAlphaOnly="0"/>
        <dd_properties>
          <Option type="Map">
            <Option value="" type="QString" name="name"/>
            <Option name="properties"/>
            <Option value="collection" type="QString" name="type"/>
          </Option>
        </dd_properties>
        <substitutions/>
      </text-style>
      <text-format addDirectionSymbol="0" formatNumbers="0" reverseDirectionSymbol="0" wrapChar="" multilineAlign="3" plussign="0" rightDirectionSymbol=">" leftDirectionSymbol="&lt;" useMaxLineLengthForAutoWrap="1" autoWrapLength="0" placeDirectionSymbol="0" decimals="3"/>
      <placement maxCurvedCharAngleIn="25" repeatDistanceUnits="MM" distMapUnitScale="3x:0,0,0,0,0,0" lineAnchorClipping="0" overrunDistance="0" repeatDistance="0" placement="0" overlapHandling="PreventOverlap" predefinedPositionOrder="TR,TL,BR,BL,R,L,TSR,BSR" geometryGeneratorEnabled="0" lineAnchorType="0" centroidInside="0" layerType="UnknownGeometry" lineAnchorTextPoint="FollowPlacement" fitInPolygonOnly="0" quadOffset="4" geometryGeneratorType="PointGeometry" prioritization="PreferCloser" overrunDistanceUnit="MM" rotationUnit="AngleDegrees" maximumDistanceUnit="MM" labelOffsetMapUnitScale="3x:0,0,0,0,0,0" overrunDistanceMapUnitScale="3x:0,0,0,0,0,0" allowDegraded="0" lineAnchorPercent="0.5" preserveRotation="1" maxCurvedCharAngleOut="-25" maximumDistance="0" polygonPlacementFlags="2" centroidWhole="0" distUnits="MM" repeatDistanceMapUnitScale="3x:0,0,0,0,0,0" maximumDistanceMapUnitScale="3x:0,0,0,0,0,0" offsetUnits="MM" placementFlags="10" offsetType="0" geometryGenerator="" dist="0" yOffset="0" rotationAngle="0" xOffset="0" priority="5"/>
      <rendering obstacle="1" maxNumLabels="2000" minFeatureSize="0" scaleMax="300" fontMinPixelSize="0" fontLimitPixelSize="0" scaleMin="0" zIndex="0" mergeLines="0" fontMaxPixelSize="10000" upsidedownLabels="0" unplacedVisibility="0" obstacleFactor="1" limitNumLabels="0" labelPerPart="0" drawLabels="1" obstacleType="1" scaleVisibility="1"/>
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
          <Option value="&lt;symbol is_animated=&quot;0&quot; frame_rate=&quot;10&quot; clip_to_extent=&quot;1&quot; alpha=&quot;1&quot; type=&quot;line&quot; name=&quot;symbol&quot; force_rhr=&quot;0&quot;>&lt;data_defined_properties>&lt;Option type=&quot;Map&quot;>&lt;Option value=&quot;&quot; type=&quot;QString&quot; name=&quot;name&quot;/>&lt;Option name=&quot;properties&quot;/>&lt;Option value=&quot;collection&quot; type=&quot;QString&quot; name=&quot;type&quot;/>&lt;/Option>&lt;/data_defined_properties>&lt;layer class=&quot;SimpleLine&quot; pass=&quot;0&quot; locked=&quot;0&quot; id=&quot;{7c4fb48c-0d83-40cc-bc32-05a32bfa2f63}&quot; enabled=&quot;1&quot;>&lt;Option type=&quot;Map&quot;>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;align_dash_pattern&quot;/>&lt;Option value=&quot;square&quot; type=&quot;QString&quot; name=&quot;capstyle&quot;/>&lt;Option value=&quot;5;2&quot; type=&quot;QString&quot; name=&quot;customdash&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;customdash_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;customdash_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;dash_pattern_offset&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;dash_pattern_offset_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;dash_pattern_offset_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;draw_inside_polygon&quot;/>&lt;Option value=&quot;bevel&quot; type=&quot;QString&quot; name=&quot;joinstyle&quot;/>&lt;Option value=&quot;60,60,60,255,rgb:0.23529411764705882,0.23529411764705882,0.23529411764705882,1&quot; type=&quot;QString&quot; name=&quot;line_color&quot;/>&lt;Option value=&quot;solid&quot; type=&quot;QString&quot; name=&quot;line_style&quot;/>&lt;Option value=&quot;0.3&quot; type=&quot;QString&quot; name=&quot;line_width&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;line_width_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;offset&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;offset_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;offset_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;ring_filter&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;trim_distance_end&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;trim_distance_end_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;trim_distance_end_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;trim_distance_start&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;trim_distance_start_map_unit_scale&quot;/>&lt;Option value=&quot;MM&quot; type=&quot;QString&quot; name=&quot;trim_distance_start_unit&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;tweak_dash_pattern_on_corners&quot;/>&lt;Option value=&quot;0&quot; type=&quot;QString&quot; name=&quot;use_custom_dash&quot;/>&lt;Option value=&quot;3x:0,0,0,0,0,0&quot; type=&quot;QString&quot; name=&quot;width_map_unit_scale&quot;/>&lt;/Option>&lt;data_defined_properties>&lt;Option type=&quot;Map&quot;>&lt;Option value=&quot;&quot; type=&quot;QString&quot; name=&quot;name&quot;/>&lt;Option name=&quot;properties&quot;/>&lt;Option value=&quot;collection&quot; type=&quot;QString&quot; name=&quot;type&quot;/>&lt;/Option>&lt;/data_defined_properties>&lt;/layer>&lt;/symbol>" type="QString" name="lineSymbol"/>
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
