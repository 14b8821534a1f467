package lightning.scene;

import static java.util.Map.entry;
import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.document.LightEdits;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.AttributeArbitraries;
import lightning.sample.AttributeArbitraries.Changed;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Beam;
import lightning.scene.light.Cone;
import lightning.scene.light.DistanceFalloff;
import lightning.scene.light.Emission;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;
import lightning.scene.light.Switches;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Bulb;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.Sheen;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.material.Transmission;
import lightning.scene.value.DomeRotation;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** Properties that hold for every attribute in the attribute tables, so that no code leaves one out. */
class AttributePropertiesTest {
    /** Material of a shape in the studio scene. */
    private static final String MATT = "matt";
    /** Titles, or keywords of scene files, that differ from the name of their component. */
    private static final Map<String,
            String> KEYWORDS = Map.ofEntries(entry("World.lightCount", "lamps"), entry("World.image", "environment"),
                    entry("Dome.lightCount", "lamps"), entry("Dome.image", "environment"),
                    entry("Transmission.color", "transparency"),
                    entry("BumpMapping.normalMap", "normals"),
                    entry("SurfaceMaps.roughness", "roughness map"), entry("SurfaceMaps.metalness", "metalness map"),
                    entry("SurfaceMaps.f0", "f0 map"), entry("SurfaceMaps.f0Channel", "f0 channel"),
                    entry("SurfaceMaps.specularTint", "specular tint map"),
                    entry("LayerMaps.coat", "coat map"), entry("LayerMaps.coatNormal", "coat normals"),
                    entry("LayerMaps.coatRoughness", "coat roughness map"),
                    entry("LayerMaps.sheen", "sheen map"), entry("LayerMaps.sheenRoughness", "sheen roughness map"),
                    entry("Cone.angle", "cone half-angle"),
                    entry("Cone.dropoff", "edge falloff"), entry("Cone.doors", "barn doors"), entry("Cone.profile", "IES profile"),
                    entry("Beam.cone", "cone cutoff"), entry("Beam.softness", "cone softness"), entry("Beam.spread", "beam spread"),
                    entry("AreaShape.shape", "shining object"), entry("AreaShape.up", "roll axis"),
                    entry("AreaShape.visibility", "visible to camera"),
                    entry("Transmission.ior", "IOR"), entry("Anisotropy.strength", "anisotropy"),
                    entry("Anisotropy.rotation", "anisotropy rotation"), entry("Coat.weight", "coat"),
                    entry("Coat.roughness", "coat roughness"),
                    entry("Coat.ior", "coat IOR"), entry("Sheen.color", "sheen"), entry("Sheen.roughness", "sheen roughness"),
                    entry("Emission.unit", "intensity unit"), entry("LightFlag.on", "flag"), entry("LightFlag.position", "flag position"),
                    entry("LightFlag.rotation", "flag rotation"), entry("LightFlag.width", "flag width"),
                    entry("LightFlag.height", "flag height"), entry("LightFlag.softness", "flag softness"),
                    entry("LightFlag.density", "flag density"), entry("LightFilter.shape", "filter"),
                    entry("LightFilter.position", "filter position"), entry("LightFilter.rotation", "filter rotation"),
                    entry("LightFilter.size", "filter size"), entry("LightFilter.softness", "filter softness"),
                    entry("LightFilter.density", "filter density"), entry("LightFilter.inverted", "filter invert"),
                    entry("Influence.diffuse", "diffuse gain"), entry("Influence.specular", "specular gain"),
                    entry("Influence.fog", "fog gain"), entry("Influence.gains", "gains on objects"));

    @Provide
    Arbitrary<Changed<Light>> lights() {
        return AttributeArbitraries.lights();
    }

    @Provide
    Arbitrary<Changed<Material>> materials() {
        return AttributeArbitraries.materials(MATT);
    }

    @Example
    void everyRecordComponent_isAnAttribute() {
        assertThat(titles(LightAttribute.ALL)).containsExactlyInAnyOrderElementsOf(components(Light.class));
        assertThat(titles(MaterialAttribute.ALL)).containsExactlyInAnyOrderElementsOf(components(Material.class));
        // Not by title: titles of the world name the owner of an intensity or a rotation.
        List<String> rotation = components(DomeRotation.class);
        List<String> dome = components(Dome.class);
        assertThat(Dome.ATTRIBUTES.stream().map(SceneAttribute::name).map(name -> rotation.contains(name) ? "rotation" : name).distinct())
                .containsExactlyInAnyOrderElementsOf(dome.stream().filter(name -> !name.equals("sky")).toList());
        List<String> world = new ArrayList<>(components(World.class));
        world.remove("domes");
        world.addAll(dome);
        world.remove("on");
        assertThat(World.ATTRIBUTES.stream().map(SceneAttribute::name).filter(name -> !name.startsWith("fog_") && !name.startsWith("sky_"))
                .map(name -> rotation.contains(name) ? "rotation" : name).distinct()).containsExactlyInAnyOrderElementsOf(world);
        assertThat(IndirectSettings.ATTRIBUTES.stream().map(SceneAttribute::name))
                .containsExactlyInAnyOrderElementsOf(components(IndirectSettings.class));
    }

    private static List<String> titles(List<? extends SceneAttribute<?, ?>> attributes) {
        return attributes.stream().map(SceneAttribute::title).toList();
    }

    private static List<String> components(Class<? extends Record> type) {
        return Arrays.stream(type.getRecordComponents()).flatMap(AttributePropertiesTest::names).filter(n -> !n.equals("name"))
                .toList();
    }

    private static String keyword(RecordComponent component) {
        return KEYWORDS.getOrDefault(component.getDeclaringRecord().getSimpleName() + "." + component.getName(),
                component.getName().replaceAll("(?=[A-Z])", " ").toLowerCase(Locale.ROOT));
    }

    /** Returns the names of a component's attributes. Records in lights and materials, such as area shapes, have one for each component. */
    private static Stream<String> names(RecordComponent component) {
        if (component.getType() == Bulb.class) {
            // Its glow is derived from the light.
            return Stream.of("bulb of", "bulb exposure");
        }
        if (component.getType() == AlphaCutout.class) {
            // Only the face of a light is clipped.
            return Stream.of("cutout", "cutoff");
        }
        if (component.getName().equals("hardShadows") || component.getType() == Optional.class && component.getName().equals("surface")) {
            // Only a view without soft shadows has the first; the second is derived from a shape.
            return Stream.empty();
        }
        return component.getType() == AreaShape.class || component.getType() == Cone.class || component.getType() == Beam.class
                || component.getType() == Switches.class
                || component.getType() == DistanceFalloff.class || component.getType() == Emission.class
                || component.getType() == BumpMapping.class
                || component.getType() == Anisotropy.class
                || component.getType() == Coat.class
                || component.getType() == Sheen.class
                || component.getType() == SurfaceMaps.class
                || component.getType() == LayerMaps.class
                || component.getType() == Transmission.class
                || component.getType() == Influence.class
                || component.getType() == LightFlag.class
                || component.getType() == LightFilter.class
                        ? components(component.getType().asSubclass(Record.class)).stream() : Stream.of(keyword(component));
    }

    @Property
    void setValue_changesOnlyThatAttribute(@ForAll("lights") Changed<Light> changed) {
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute != changed.attribute()) {
                assertThat(attribute.get(changed.after())).as(attribute.title()).isEqualTo(attribute.get(changed.before()));
            }
        }
        assertThat(copy(changed.attribute(), changed.after(), changed.before())).isEqualTo(changed.after());
    }

    private static <T> T copy(SceneAttribute<T, ?> attribute, T from, T to) {
        return attribute.copy(from, to);
    }

    @Property
    void changedAttribute_isDescribed(@ForAll("lights") Changed<Light> light, @ForAll("materials") Changed<Material> material) {
        Scene studio = StudioScene.of(LightType.SPOT);
        assertDescribed(light.attribute(), light, studio.withLight(light.before()), studio.withLight(light.after()));
        assertDescribed(material.attribute(), material, studio.withMaterial(material.before()), studio.withMaterial(material.after()));
    }

    private static <T> void assertDescribed(SceneAttribute<T, ?> attribute, Changed<T> changed, Scene before, Scene after) {
        String was = attribute.format(changed.before());
        String is = attribute.format(changed.after());
        if (!was.equals(is)) {
            assertThat(SceneDiff.summarize(before, after)).endsWith(": " + attribute.title() + " " + was + " → " + is);
        } else if (!changed.before().equals(changed.after())) {
            assertThat(SceneDiff.summarize(before, after)).endsWith(": small change");
        }
    }

    @Property
    void pastedSettings_excludePositionAndSwitches(@ForAll("lights") Changed<Light> changed) {
        Scene scene = StudioScene.of(LightType.SPOT).withLight(changed.before());
        Scene pasted = LightEdits.pasteSettings(scene, StudioScene.KEY, changed.after()).sceneOr(scene);
        boolean isExcluded = List.of(LightAttribute.POSITION, LightAttribute.DIRECTION, LightAttribute.ON, LightAttribute.SOLO,
                LightAttribute.ILLUMINATES, LightAttribute.SHADOWED_BY, LightAttribute.GAINS)
                .contains(changed.attribute());
        assertThat(pasted.lights()).containsExactly(isExcluded ? changed.before() : changed.after());
    }

    /** An update must have the bits of a full trace, and a change classified as invisible must not change the picture. */
    @Property(tries = 400, edgeCases = EdgeCasesMode.NONE)
    @Slow
    void changedLight_matchesFullTrace(@ForAll("lights") Changed<Light> changed) {
        Scene studio = StudioScene.of(changed.before().type());
        assertUpdated(studio.withLight(changed.before()), studio.withLight(changed.after()), changed.attribute());
    }

    @Property(tries = 150, edgeCases = EdgeCasesMode.NONE)
    void changedMaterial_matchesFullTrace(@ForAll("materials") Changed<Material> changed) {
        Scene studio = StudioScene.of(LightType.SPOT);
        assertUpdated(studio.withMaterial(changed.before()), studio.withMaterial(changed.after()), changed.attribute());
    }

    private static void assertUpdated(Scene before, Scene after, SceneAttribute<?, ?> attribute) {
        var full = new ReferenceTracer(after).trace();
        if (VisibleState.isSame(before, after)) {
            assertThat(new ReferenceTracer(before).trace().hasSameBits(full)).as("%s is invisible", attribute).isTrue();
        }
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            String plan = renderer.render(after, Progress.NONE).plan().description();
            assertThat(renderer.film().hasSameBits(full)).as("%s: %s", attribute, plan).isTrue();
        }
    }
}
