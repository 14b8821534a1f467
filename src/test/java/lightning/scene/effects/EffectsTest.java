package lightning.scene.effects;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import lightning.format.jen.JenReader;
import lightning.sample.Meshes;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import org.junit.jupiter.api.Test;

class EffectsTest {
    private static final String PLAIN = "material grey { diffuse 0.5 0.5 0.5 }\nsphere ball { material grey }\n";

    private static Effects of(String... text) throws Exception {
        Scene scene = JenReader.read("jen 1\n" + String.join("\n", text), "test", Path.of("")).scene();
        return Effects.of(scene);
    }

    @Test
    void emptyScene_callsForNothing() throws Exception {
        assertThat(of("light a point {}").absent()).isEqualTo(Set.copyOf(Effect.ALL));
    }

    @Test
    void plainLight_callsForShadowsAndItsType() throws Exception {
        Effects effects = of(PLAIN, "light a point {}");
        assertThat(effects.callers().keySet()).containsExactly(Effect.SHADOWS, Effect.of("point-lights"), Effect.of("spheres"));
        assertThat(effects.callers(Effect.SHADOWS)).containsExactly("a");
        assertThat(effects.depth()).isZero();
    }

    @Test
    void attributesThatDoNotAct_callForNothing() throws Exception {
        Effects effects = of(PLAIN, "light a directional { attenuation 1 1 1  angle 20  dropoff 5 }",
                "light b point { angle 20  dropoff 5  doors 1 2 3 4 }",
                "light c spot { angle 180  feather 5 }");
        assertThat(effects.absent()).contains(Effect.ATTENUATION, Effect.SPOT_CONE, Effect.DROPOFF, Effect.BARN_DOORS);
    }

    @Test
    void attributesThatAct_areCalledForByName() throws Exception {
        Effects effects = of(PLAIN, "light a spot { attenuation 1 1 1  angle 20  dropoff 5 }", "light b spot { angle 180 }");
        assertThat(effects.callers(Effect.ATTENUATION)).containsExactly("a");
        assertThat(effects.callers(Effect.SPOT_CONE)).containsExactly("a");
        assertThat(effects.callers(Effect.DROPOFF)).containsExactly("a");
        assertThat(effects.callers(Effect.of("spot-lights"))).containsExactly("a", "b");
    }

    @Test
    void darkLights_callForNothing() throws Exception {
        Effects effects = of(PLAIN, "light a point { on no }", "light b point { intensity 0 }", "light c spot { color 0 0 0 }");
        assertThat(effects.callers().keySet()).containsExactly(Effect.of("spheres"));
    }

    @Test
    void banksThatMakeALightAnother_areCalledForByName() throws Exception {
        String lights = "light a point { bank left }\nlight b point { bank right }";
        assertThat(of(PLAIN, "bank left {}", "bank right {}", lights).has(Effect.BANKS)).isFalse();
        assertThat(of(PLAIN, "bank left { intensity 0.5 }", "bank right {}", lights).callers(Effect.BANKS)).containsExactly("left");
    }

    @Test
    void darkBank_silencesTheCallsOfItsLights() throws Exception {
        assertThat(of(PLAIN, "bank left { on no }", "light a point { bank left }").callers().keySet())
                .containsExactly(Effect.BANKS, Effect.of("spheres"));
    }

    @Test
    void soloLight_silencesTheCallsOfOthers() throws Exception {
        Effects effects = of(PLAIN, "light a point { solo yes }", "light b spot { dropoff 3 }");
        assertThat(effects.callers(Effect.SHADOWS)).containsExactly("a");
        assertThat(effects.has(Effect.DROPOFF)).isFalse();
    }

    @Test
    void materialsOnShapes_callForSpecularAndReflection() throws Exception {
        Effects effects = of("material used { specular 0.5 0.5 0.5  reflective 0 0.1 0 }",
                "material unused { specular 1 1 1  reflective 1 1 1 }", "cone c { material used }", "light a point {}",
                "picture { depth 4 }");
        assertThat(effects.callers(Effect.SPECULAR)).containsExactly("used");
        assertThat(effects.callers(Effect.REFLECTION)).containsExactly("used");
        assertThat(effects.depth()).isEqualTo(4);
        assertThat(effects.callers(Effect.of("cones"))).containsExactly("c");
    }

    @Test
    void mirrorsAtDepth0_callForNoReflection() throws Exception {
        Effects effects = of("material m { reflective 1 1 1 }", "plane p { material m }", "picture { depth 0 }");
        assertThat(effects.has(Effect.REFLECTION)).isFalse();
    }

    @Test
    void clearMaterials_letRaysBounceThoughNothingMirrors() throws Exception {
        String glass = "material glass { clear 1 1 1 }\n";
        Effects effects = of(glass, "plane p { material glass }", "picture { depth 4 }");
        assertThat(effects.has(Effect.REFLECTION)).isFalse();
        assertThat(effects.depth()).isEqualTo(4);
        assertThat(of(glass, "plane p { material glass }", "picture { depth 0 }").depth()).isZero();
        assertThat(of(glass, "plane p {}", "picture { depth 4 }").depth()).as("no shape is of it").isZero();
        assertThat(of("material air { shadows none }", "plane p { material air }", "picture { depth 4 }").depth()).isZero();
    }

    @Test
    void highlightsWithoutLight_areNotCalledFor() throws Exception {
        assertThat(of("material m { specular 1 1 1 }", "cylinder c { material m }").callers().keySet())
                .containsExactly(Effect.of("cylinders"));
    }

    @Test
    void finerSamples_areCalledForByThePicture() throws Exception {
        assertThat(of(PLAIN, "picture { antialias edges }").callers(Effect.ANTIALIASING)).containsExactly("picture");
        assertThat(of(PLAIN, "picture { antialias off  samples 8 }").has(Effect.ANTIALIASING)).isFalse();
    }

    @Test
    void colorsOfVertices_areCalledForByShapesThatShowThem() throws Exception {
        Scene lit = JenReader.read("jen 1\nlight a point {}\n", "test", Path.of("")).scene();
        Solid.Triangles tinted = Meshes.solid(Meshes.tinted(Meshes.cube()));
        Scene scene = lit.withNodes(
                List.of(shape("shown", tinted), shape("hidden", tinted.withColors(false)), shape("plain", Meshes.solid(Meshes.cube()))));
        assertThat(Effects.of(scene).callers(Effect.VERTEX_COLORS)).containsExactly("shown");
        assertThat(Effects.of(ViewEffects.ALL.hiding(Set.of(Effect.VERTEX_COLORS)).of(scene)).has(Effect.VERTEX_COLORS)).isFalse();
    }

    private static Node shape(String name, Solid solid) {
        return new Shape(solid, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    @Test
    void bird_callsForNoneOfTheLightsAndSurfacesThatItLacks() throws Exception {
        assertThat(Effects.of(JenReader.read(Path.of("scenes/bird.jen")).scene()).absent()).containsExactly(Effect.METALLIC,
                Effect.CUTOUTS, Effect.BUMPS, Effect.VERTEX_COLORS, Effect.CLEAR, Effect.TINTED_SHADOWS, Effect.BARN_DOORS, Effect.GOBOS,
                Effect.PROFILES, Effect.LIGHT_LINKS,
                Effect.SHADOW_LINKS,
                Effect.BANKS, Effect.SOFT_SHADOWS, Effect.ANTIALIASING, Effect.ENVIRONMENT, Effect.of("rect-lights"),
                Effect.of("disc-lights"),
                Effect.of("frustums"), Effect.of("meshes"));
    }
}
