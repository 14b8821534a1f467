package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.lang.foreign.MemorySegment;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.TileLevel;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.tile.SmallNightScene;
import lightning.render.shading.layer.LightRows;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;

/**
 * Tests layers of many lights without highlights, which store cosine times falloff: edits that need one of the two still give the
 * bits of a full trace.
 */
class PremultipliedLayersTest {
    private static final RenderOptions CURRENT = RenderOptions.DEFAULT.withReflections(ReflectionMode.CURRENT).withThreads(1);
    private static final Scene NIGHT = SmallNightScene.SCENE;

    private static List<LightRows> layers(Renderer renderer) {
        return Arrays.stream(renderer.cache().tiles()).flatMap(tile -> Arrays.stream(tile.levels())).map(TileLevel::layers)
                .flatMap(Arrays::stream).map(LightRows.class::cast).toList();
    }

    private static long lone(Renderer renderer) {
        return layers(renderer).stream().filter(l -> l.falloff != null && l.specular == null && l.bytes(LightRows.Column.FALLOFF) > 0)
                .filter(l -> l.kind() == LightRows.Kind.SEPARATE).count();
    }

    @Test
    void eightLightsWithoutHighlight_premultiplyFalloff() {
        for (int lights : new int[] {ExactMethod.MIN_PREMULTIPLIED_LIGHTS - 1, ExactMethod.MIN_PREMULTIPLIED_LIGHTS}) {
            try (Renderer renderer = new Renderer(CURRENT)) {
                renderer.render(NIGHT.withLights(NIGHT.lights().subList(0, lights)), Progress.NONE);
                assertThat(lone(renderer) == 0).as(lights + " lights").isEqualTo(lights >= ExactMethod.MIN_PREMULTIPLIED_LIGHTS);
            }
        }
    }

    @Test
    void highlight_keepsFalloffSeparate() {
        try (Renderer renderer = new Renderer(CURRENT)) {
            renderer.render(NIGHT, Progress.NONE);
            assertThat(layers(renderer)).filteredOn(l -> l.specular != null && l.falloff != null)
                    .isNotEmpty().allMatch(l -> l.bytes(LightRows.Column.FALLOFF) > 0);
        }
    }

    @Test
    void savedLayer_recordsPremultipliedFalloff() throws Exception {
        try (Renderer renderer = new Renderer(CURRENT)) {
            renderer.render(NIGHT, Progress.NONE);
            LightRows layer = layers(renderer).stream().filter(l -> l.kind() == LightRows.Kind.PREMULTIPLIED).findFirst().orElseThrow();
            var bytes = new ByteArrayOutputStream();
            var out = new ColumnWriter(Channels.newChannel(bytes));
            layer.writeTo(out);
            out.writeChecksum();
            ByteBuffer file = ByteBuffer.allocateDirect(bytes.size()).put(bytes.toByteArray()).flip();
            assertThat(LightRows.readFrom(new ColumnReader(MemorySegment.ofBuffer(file))).kind()).isEqualTo(LightRows.Kind.PREMULTIPLIED);
        }
    }

    @Test
    void changedFalloffs_equalFullTrace() {
        assertEqualsFullTrace(withFalloff(NIGHT));
        edit(l -> l.withAttenuation(new Attenuation(1, 0, 0)));
    }

    private static Scene withFalloff(Scene scene) {
        return scene.withLights(scene.lights().stream()
                .map(l -> l.type() == LightType.DIRECTIONAL ? l : l.withAttenuation(new Attenuation(0.3, 0.2, 0.1))).toList());
    }

    @Test
    void changedCones_equalFullTrace() {
        edit(l -> l.type() == LightType.SPOT ? l.withDropoff(l.dropoff() + 3) : l);
        edit(l -> l.type() == LightType.SPOT ? l.withAngle(l.angle() * 0.7) : l);
        edit(l -> l.type() == LightType.SPOT ? l.withAngle(l.angle() * 1.2) : l);
    }

    private static void edit(UnaryOperator<Light> edit) {
        assertEqualsFullTrace(NIGHT.withLights(NIGHT.lights().stream().map(edit).toList()));
    }

    @Test
    void addedHighlights_equalFullTrace() {
        assertEqualsFullTrace(withFloorMaterial(m -> m.withSpecular(new Rgb(0.3, 0.3, 0.3)).withShininess(4)));
    }

    @Test
    void addedMirrors_equalFullTrace() {
        Scene mirrored = withFloorMaterial(m -> m.withReflective(new Rgb(0.3, 0.3, 0.3)));
        assertEqualsFullTrace(mirrored, withFalloff(mirrored));
    }

    /** Returns the scene with another material on all shapes without highlights. */
    private static Scene withFloorMaterial(UnaryOperator<Material> edit) {
        return NIGHT.withMaterials(NIGHT.materials().stream().map(m -> m.specular().isBlack() ? edit.apply(m) : m).toList());
    }

    @Test
    void movedShape_equalsFullTrace() {
        SceneNode shape = NIGHT.nodes().stream().filter(node -> node.name().equals("inn")).findFirst().orElseThrow();
        Vec3 to = shape.placement().position().plus(new Vec3(0.2, 0.1, 1));
        assertEqualsFullTrace(NIGHT.withNode(shape.name(), shape.withPlacement(shape.placement().withPosition(to))));
    }

    private static void assertEqualsFullTrace(Scene... edited) {
        try (Renderer renderer = new Renderer(CURRENT); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(NIGHT, Progress.NONE);
            for (Scene target : Stream.concat(Arrays.stream(edited), Stream.of(NIGHT)).toList()) {
                renderer.render(target, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(target).trace(workers, Progress.NONE).film(), "edited");
            }
        }
    }
}
