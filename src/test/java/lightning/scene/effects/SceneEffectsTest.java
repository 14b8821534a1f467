package lightning.scene.effects;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.format.jen.JenReader;
import lightning.sample.SampleMeshes;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class SceneEffectsTest {
    private static final String PLAIN = "material gray { diffuse 0.5 0.5 0.5 }\nsphere ball { material gray }\n";

    private static SceneEffects of(String... text) throws Exception {
        Scene scene = JenReader.read("jen 1\n" + String.join("\n", text), "test", Path.of("")).scene();
        return SceneEffects.of(scene);
    }

    @Test
    void emptyScene_usesNoEffects() throws Exception {
        assertThat(of("light a point {}").unused()).isEqualTo(Set.copyOf(RenderEffect.ALL));
    }

    @Test
    void plainLight_usesShadowsAndItsType() throws Exception {
        SceneEffects effects = of(PLAIN, "light a point {}");
        assertThat(effects.users().keySet()).containsExactly(RenderEffect.SHADOWS, RenderEffect.of("point-lights"),
                RenderEffect.of("spheres"));
        assertThat(effects.users(RenderEffect.SHADOWS)).containsExactly("a");
        assertThat(effects.maxBounces()).isZero();
    }

    @Test
    void gain_countsWhereItChangesLight() throws Exception {
        String cone = "cone other { material gray }\n";
        assertThat(of(PLAIN, cone, "light a point { gains \"ball\" 1 }").unused()).contains(RenderEffect.LIGHT_GAINS);
        assertThat(of(PLAIN, cone, "light a point { illuminates only \"ball\"  gains \"other\" 0.5 }").unused())
                .contains(RenderEffect.LIGHT_GAINS);
        assertThat(of(PLAIN, cone, "light a point { illuminates only \"ball\"  gains \"ball\" 0.5 }").users(RenderEffect.LIGHT_GAINS))
                .containsExactly("a");
        assertThat(of(PLAIN, "light a point { specular 0.5 }").users(RenderEffect.LIGHT_GAINS)).containsExactly("a");
    }

    @Test
    void inactiveAttributes_useNoEffects() throws Exception {
        SceneEffects effects = of(PLAIN, "light a directional { attenuation 1 1 1  angle 20  dropoff 5 }",
                "light b point { angle 20  dropoff 5  doors 1 2 3 4 }",
                "light c spot { angle 180  feather 5 }");
        assertThat(effects.unused()).contains(RenderEffect.ATTENUATION, RenderEffect.SPOT_CONE, RenderEffect.DROPOFF,
                RenderEffect.BARN_DOORS);
    }

    @Test
    void activeAttributes_areListedByName() throws Exception {
        SceneEffects effects = of(PLAIN, "light a spot { attenuation 1 1 1  angle 20  dropoff 5 }", "light b spot { angle 180 }");
        assertThat(effects.users(RenderEffect.ATTENUATION)).containsExactly("a");
        assertThat(effects.users(RenderEffect.SPOT_CONE)).containsExactly("a");
        assertThat(effects.users(RenderEffect.DROPOFF)).containsExactly("a");
        assertThat(effects.users(RenderEffect.of("spot-lights"))).containsExactly("a", "b");
    }

    @Test
    void shapedFaces_useTheEffectsOfTheirShape() throws Exception {
        SceneEffects effects = of(PLAIN, "light a rect { cone 30 }", "light b disc { beam_spread 20  dropoff 2 }",
                "light c spot { cone 30 }", "light d rect { doors 1 2 3 4 }", "light e disc { doors 1 2 3 4 }");
        assertThat(effects.users(RenderEffect.BEAMS)).containsExactly("a", "b");
        assertThat(effects.users(RenderEffect.DROPOFF)).containsExactly("b");
        assertThat(effects.users(RenderEffect.BARN_DOORS)).containsExactly("d", "e");
    }

    @Test
    void lightsWithoutSoftShadows_keepFaceAndBrightness() throws Exception {
        Scene scene = JenReader.read("""
                jen 1
                light a rect { width 2  height 3  visible yes  unit nit  intensity 5 }
                light b point { radius 0.5  visible yes  falloff inverse_square }
                light c disc { radius 2  falloff inverse_square  samples 4 }
                light d point { falloff inverse_square }
                """, "test", Path.of("")).scene();
        Scene hard = RenderEffect.SOFT_SHADOWS.removeFrom(scene);
        assertThat(hard.lights()).noneMatch(Light::isArea);
        assertThat(hard.stage().faceNames()).containsExactly("a", "b");
        assertThat(hard.stage().rendered().nodes()).isEqualTo(scene.stage().rendered().nodes());
        assertThat(hard.stage().rendered().materials()).isEqualTo(scene.stage().rendered().materials());
        for (String name : List.of("a", "b", "c", "d")) {
            assertThat(hard.rig().effectiveLight(hard.light(name).orElseThrow()).weight())
                    .isEqualTo(scene.rig().effectiveLight(scene.light(name).orElseThrow()).weight());
        }
        assertThat(hard.light("c").orElseThrow().maxFalloff()).as("of one sample")
                .isEqualTo(scene.light("c").orElseThrow().maxFalloff() / 4);
        assertThat(hard.light("d").orElseThrow()).as("already a point").isEqualTo(scene.light("d").orElseThrow());
    }

    @Test
    void lightsWithoutSoftShadows_shineInTheMeanColorOfTheirTexture() {
        var image = new Texture(2, 1, new float[] {4, 0, 1, 0, 0, 1});
        Light light = Light.of("a", LightType.RECT).withIntensity(3).withTexture(Optional.of(new LightTexture("t.hdr", image)));
        Scene scene = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, Stage.EMPTY,
                LightRig.of(List.of(light.withArea(light.area().withVisibility(FaceVisibility.GLOWING)))));
        Scene hard = RenderEffect.SOFT_SHADOWS.removeFrom(scene);
        Light center = hard.rig().effectiveLights().getFirst();
        assertThat(center.weight()).isEqualTo(new Rgb(6, 0, 3));
        assertThat(center.color().max()).isLessThanOrEqualTo(1);
        assertThat(hard.stage().rendered().materials()).isEqualTo(scene.stage().rendered().materials());
        var black = new Texture(1, 1, new float[3]);
        Scene dark = scene.withLight(scene.lights().getFirst().withTexture(Optional.of(new LightTexture("black.png", black))));
        assertThat(RenderEffect.SOFT_SHADOWS.removeFrom(dark).rig().effectiveLights().getFirst().weight()).isEqualTo(Rgb.BLACK);
    }

    @Test
    void darkLights_useNoEffects() throws Exception {
        SceneEffects effects = of(PLAIN, "light a point { on no }", "light b point { intensity 0 }", "light c spot { color 0 0 0 }");
        assertThat(effects.users().keySet()).containsExactly(RenderEffect.of("spheres"));
    }

    @Test
    void effectiveGroups_areListedByName() throws Exception {
        String lights = "light a point { bank left }\nlight b point { bank right }";
        assertThat(of(PLAIN, "bank left {}", "bank right {}", lights).has(RenderEffect.LIGHT_GROUPS)).isFalse();
        assertThat(of(PLAIN, "bank left { intensity 0.5 }", "bank right {}", lights).users(RenderEffect.LIGHT_GROUPS))
                .containsExactly("left");
    }

    @Test
    void darkGroup_disablesItsLights() throws Exception {
        assertThat(of(PLAIN, "bank left { on no }", "light a point { bank left }").users().keySet())
                .containsExactly(RenderEffect.LIGHT_GROUPS, RenderEffect.of("spheres"));
    }

    @Test
    void soloLight_disablesOthers() throws Exception {
        SceneEffects effects = of(PLAIN, "light a point { solo yes }", "light b spot { dropoff 3 }");
        assertThat(effects.users(RenderEffect.SHADOWS)).containsExactly("a");
        assertThat(effects.has(RenderEffect.DROPOFF)).isFalse();
    }

    @Test
    void materialsOnShapes_useSpecularAndReflection() throws Exception {
        SceneEffects effects = of("material used { specular 0.5 0.5 0.5  reflective 0 0.1 0 }",
                "material unused { specular 1 1 1  reflective 1 1 1 }", "cone c { material used }", "light a point {}",
                "picture { depth 4 }");
        assertThat(effects.users(RenderEffect.SPECULAR)).containsExactly("used");
        assertThat(effects.users(RenderEffect.REFLECTION)).containsExactly("used");
        assertThat(effects.maxBounces()).isEqualTo(4);
        assertThat(effects.users(RenderEffect.of("cones"))).containsExactly("c");
    }

    @Test
    void mirrorsAtDepth0_useNoReflection() throws Exception {
        SceneEffects effects = of("material m { reflective 1 1 1 }", "plane p { material m }", "picture { depth 0 }");
        assertThat(effects.has(RenderEffect.REFLECTION)).isFalse();
    }

    @Test
    void transparentMaterials_spawnRaysWithoutMirrors() throws Exception {
        String glass = "material glass { clear 1 1 1 }\n";
        SceneEffects effects = of(glass, "plane p { material glass }", "picture { depth 4 }");
        assertThat(effects.has(RenderEffect.REFLECTION)).isFalse();
        assertThat(effects.maxBounces()).isEqualTo(4);
        assertThat(of(glass, "plane p { material glass }", "picture { depth 0 }").maxBounces()).isZero();
        assertThat(of(glass, "plane p {}", "picture { depth 4 }").maxBounces()).as("no shape is of it").isZero();
        assertThat(of("material air { shadows none }", "plane p { material air }", "picture { depth 4 }").maxBounces()).isZero();
    }

    @Test
    void highlightsWithoutLight_areUnused() throws Exception {
        assertThat(of("material m { specular 1 1 1 }", "cylinder c { material m }").users().keySet())
                .containsExactly(RenderEffect.of("cylinders"));
    }

    @Test
    void glowingMaterialsOnShapes_areListedByNameAndRemoved() throws Exception {
        Scene scene = JenReader.read(
                "jen 1 material neon { glow 0 0.1 0 } material unused { glow 1 1 1 } material gray {} "
                        + "plane p { material neon } cone c { material gray }",
                "test", Path.of("")).scene();
        SceneEffects effects = SceneEffects.of(scene);
        assertThat(effects.users(RenderEffect.GLOW)).containsExactly("neon");
        assertThat(RenderEffect.GLOW.isForcible()).isFalse();
        assertThat(SceneEffects.of(ViewEffects.ALL.withHidden(Set.of(RenderEffect.GLOW)).apply(scene)).has(RenderEffect.GLOW)).isFalse();
    }

    @Test
    void supersampling_isUsedByThePicture() throws Exception {
        assertThat(of(PLAIN, "picture { antialias edges }").users(RenderEffect.ANTIALIASING)).containsExactly("picture");
        assertThat(of(PLAIN, "picture { antialias off  samples 8 }").has(RenderEffect.ANTIALIASING)).isFalse();
    }

    @Test
    void indirectLight_isUsedByThePicture() throws Exception {
        SceneEffects effects = of(PLAIN, "picture { indirect { bounces 3 } }");
        assertThat(effects.reason(RenderEffect.INDIRECT)).isEqualTo("3 bounces, 64 rays, every 8 pixels");
        assertThat(of(PLAIN).has(RenderEffect.INDIRECT)).isFalse();
        assertThat(of("picture { indirect {} }").has(RenderEffect.INDIRECT)).as("without shapes").isFalse();
    }

    @Test
    void indirectLight_isRemovedAndNotAdded() throws Exception {
        Scene without = JenReader.read("jen 1\npicture { depth 5 }\n" + PLAIN, "test", Path.of("")).scene();
        Scene scene = without.withPicture(without.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        assertThat(ViewEffects.ALL.with(RenderEffect.INDIRECT, false).apply(scene)).isEqualTo(without);
        assertThat(ViewEffects.ALL.withForced(Set.of(RenderEffect.INDIRECT)).apply(without)).isEqualTo(without);
        assertThat(ViewEffects.PREVIEW.apply(scene).picture().indirect()).isEmpty();
        assertThat(RenderEffect.of("indirect")).isSameAs(RenderEffect.INDIRECT);
    }

    @Test
    void vertexColors_areUsedByShapesShowingThem() throws Exception {
        Scene lit = JenReader.read("jen 1\nlight a point {}\n", "test", Path.of("")).scene();
        Solid.TriangleMesh tinted = SampleMeshes.solid(SampleMeshes.withVertexColors(SampleMeshes.cube()));
        Scene scene = lit.withNodes(
                List.of(shape("shown", tinted), shape("hidden", tinted.withShowsColors(false)),
                        shape("plain", SampleMeshes.solid(SampleMeshes.cube()))));
        assertThat(SceneEffects.of(scene).users(RenderEffect.VERTEX_COLORS)).containsExactly("shown");
        assertThat(SceneEffects.of(ViewEffects.ALL.withHidden(Set.of(RenderEffect.VERTEX_COLORS)).apply(scene))
                .has(RenderEffect.VERTEX_COLORS)).isFalse();
    }

    private static SceneNode shape(String name, Solid solid) {
        return new Shape(solid, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    @Test
    void bird_usesOnlyItsEffects() throws Exception {
        assertThat(SceneEffects.of(JenReader.read(Path.of("scenes/bird.jen")).scene()).unused()).containsExactly(RenderEffect.METALLIC,
                RenderEffect.CUTOUTS, RenderEffect.BUMPS, RenderEffect.VERTEX_COLORS, RenderEffect.BLURRED_REFLECTIONS,
                RenderEffect.TRANSMISSION,
                RenderEffect.GLOW,
                RenderEffect.TINTED_SHADOWS, RenderEffect.BARN_DOORS, RenderEffect.BEAMS, RenderEffect.GOBOS, RenderEffect.FLAGS,
                RenderEffect.LIGHT_FILTERS, RenderEffect.PROFILES, RenderEffect.LIGHT_TEXTURES, RenderEffect.LIGHT_LINKS,
                RenderEffect.SHADOW_LINKS, RenderEffect.LIGHT_GAINS,
                RenderEffect.LIGHT_GROUPS, RenderEffect.VISIBLE_LIGHTS, RenderEffect.SOFT_SHADOWS,
                RenderEffect.DEPTH_OF_FIELD, RenderEffect.ENVIRONMENT, RenderEffect.FOG,
                RenderEffect.INDIRECT,
                RenderEffect.of("rect-lights"),
                RenderEffect.of("disc-lights"), RenderEffect.of("tube-lights"), RenderEffect.of("object-lights"),
                RenderEffect.of("frustums"), RenderEffect.of("meshes"));
    }
}
