<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis version="3.40.6-Bratislava" styleCategories="Symbology|Symbology3D|Labeling|Fields|Forms|MapTips|AttributeTable|Rendering|Temporal|Elevation" autoRefreshTime="0" hasScaleBasedVisibilityFlag="0" autoRefreshMode="Disabled" minScale="1e+08" maxScale="0">
  <temporal durationField="" mode="0" endField="" startField="" durationUnit="min" enabled="0" limitMode="0" startExpression="" fixedDuration="0" accumulate="0" endExpression="">
    <fixedRange>
      <start></start>
      <end></end>
    </fixedRange>
  </temporal>
  <elevation symbology="Line" respectLayerSymbol="1" clamping="Terrain" type="IndividualFeatures" showMarkerSymbolInSurfacePlots="0" binding="Centroid" zoffset="0" extrusion="0" zscale="1" extrusionEnabled="0">
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
        <layer pass="0" locked="0" enabled="1" class="SimpleLine" id="{a607021d-ef7d-4f60-9c1e-73c3ea1f955d}">
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
            <Option type="QString" name="line_color" value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1"/>
            <Option type="QString" name="line_style" value="solid"/>
            <Option type="QString" name="line_width" value="0.6"/>
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
        <layer pass="0" locked="0" enabled="1" class="SimpleFill" id="{792db9b7-f743-4075-a842-7ff7daf4389d}">
          <Option type="Map">
            <Option type="QString" name="border_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="color" value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="166,81,101,255,rgb:0.64985122453650723,0.31651789120317386,0.39496452277409017,1"/>
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
        <layer pass="0" locked="0" enabled="1" class="SimpleMarker" id="{9d1529f4-7d01-43e4-ad26-c55059a87101}">
          <Option type="Map">
            <Option type="QString" name="angle" value="0"/>
            <Option type="QString" name="cap_style" value="square"/>
            <Option type="QString" name="color" value="232,113,141,255,rgb:0.90980392156862744,0.44313725490196076,0.55294117647058827,1"/>
            <Option type="QString" name="horizontal_anchor_point" value="1"/>
            <Option type="QString" name="joinstyle" value="bevel"/>
            <Option type="QString" name="name" value="diamond"/>
            <Option type="QString" name="offset" value="0,0"/>
            <Option type="QString" name="offset_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="offset_unit" value="MM"/>
            <Option type="QString" name="outline_color" value="166,81,101,255,rgb:0.64985122453650723,0.31651789120317386,0.39496452277409017,1"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.2"/>
            <Option type="QString" name="outline_width_map_unit_scale" value="3x:0,0,0,0,0,0"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
            <Option type="QString" name="scale_method" value="diameter"/>
            <Option type="QString" name="size" value="3"/>
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
  <fieldConfiguration>
    <field configurationFlags="NoFlag" name="unit_id">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="epoch_from">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="epoch_to">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="decision">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="comment">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="reviewer">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="reviewed_at">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="confirmed_by">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
    <field configurationFlags="NoFlag" name="confirmed_at">
      <editWidget type="">
        <config>
          <Option/>
        </config>
      </editWidget>
    </field>
  </fieldConfiguration>
  <aliases>
    <alias field="unit_id" index="0" name="Unit"/>
    <alias field="epoch_from" index="1" name="From epoch"/>
    <alias field="epoch_to" index="2" name="To epoch"/>
    <alias field="decision" index="3" name="Decision"/>
    <alias field="comment" index="4" name="Comment"/>
    <alias field="reviewer" index="5" name="Reviewer"/>
    <alias field="reviewed_at" index="6" name="Reviewed [UTC]"/>
    <alias field="confirmed_by" index="7" name="Confirmed by"/>
    <alias field="confirmed_at" index="8" name="Confirmed [UTC]"/>
  </aliases>
  <splitPolicies>
    <policy field="unit_id" policy="Duplicate"/>
    <policy field="epoch_from" policy="Duplicate"/>
    <policy field="epoch_to" policy="Duplicate"/>
    <policy field="decision" policy="Duplicate"/>
    <policy field="comment" policy="Duplicate"/>
    <policy field="reviewer" policy="Duplicate"/>
    <policy field="reviewed_at" policy="Duplicate"/>
    <policy field="confirmed_by" policy="Duplicate"/>
    <policy field="confirmed_at" policy="Duplicate"/>
  </splitPolicies>
  <duplicatePolicies>
    <policy field="unit_id" policy="Duplicate"/>
    <policy field="epoch_from" policy="Duplicate"/>
    <policy field="epoch_to" policy="Duplicate"/>
    <policy field="decision" policy="Duplicate"/>
    <policy field="comment" policy="Duplicate"/>
    <policy field="reviewer" policy="Duplicate"/>
    <policy field="reviewed_at" policy="Duplicate"/>
    <policy field="confirmed_by" policy="Duplicate"/>
    <policy field="confirmed_at" policy="Duplicate"/>
  </duplicatePolicies>
  <defaults>
    <default field="unit_id" expression="" applyOnUpdate="0"/>
    <default field="epoch_from" expression="" applyOnUpdate="0"/>
    <default field="epoch_to" expression="" applyOnUpdate="0"/>
    <default field="decision" expression="" applyOnUpdate="0"/>
    <default field="comment" expression="" applyOnUpdate="0"/>
    <default field="reviewer" expression="" applyOnUpdate="0"/>
    <default field="reviewed_at" expression="" applyOnUpdate="0"/>
    <default field="confirmed_by" expression="" applyOnUpdate="0"/>
    <default field="confirmed_at" expression="" applyOnUpdate="0"/>
  </defaults>
  <constraints>
    <constraint constraints="0" field="unit_id" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="epoch_from" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="epoch_to" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="decision" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="comment" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="reviewer" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="reviewed_at" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="confirmed_by" notnull_strength="0" unique_strength="0" exp_strength="0"/>
    <constraint constraints="0" field="confirmed_at" notnull_strength="0" unique_strength="0" exp_strength="0"/>
  </constraints>
  <constraintExpressions>
    <constraint field="unit_id" exp="" desc=""/>
    <constraint field="epoch_from" exp="" desc=""/>
    <constraint field="epoch_to" exp="" desc=""/>
    <constraint field="decision" exp="" desc=""/>
    <constraint field="comment" exp="" desc=""/>
    <constraint field="reviewer" exp="" desc=""/>
    <constraint field="reviewed_at" exp="" desc=""/>
    <constraint field="confirmed_by" exp="" desc=""/>
    <constraint field="confirmed_at" exp="" desc=""/>
  </constraintExpressions>
  <expressionfields/>
  <attributetableconfig actionWidgetStyle="dropDown" sortExpression="" sortOrder="0">
    <columns>
      <column hidden="0" type="field" width="-1" name="unit_id"/>
      <column hidden="0" type="field" width="-1" name="epoch_from"/>
      <column hidden="0" type="field" width="-1" name="epoch_to"/>
      <column hidden="0" type="field" width="-1" name="decision"/>
      <column hidden="0" type="field" width="-1" name="comment"/>
      <column hidden="0" type="field" width="-1" name="reviewer"/>
      <column hidden="0" type="field" width="-1" name="reviewed_at"/>
      <column hidden="0" type="field" width="-1" name="confirmed_by"/>
      <column hidden="0" type="field" width="-1" name="confirmed_at"/>
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
  <mapTip enabled="1"></mapTip>
  <layerGeometryType>4</layerGeometryType>
</qgis>
