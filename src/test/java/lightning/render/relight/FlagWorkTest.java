package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.UnaryOperator;
import lightning.base.math.Vec3;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.FilterShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;
import lightning.scene.value.Fog;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that edits of flags and filters cast no ray. */
class FlagWorkTest {
    private static final LightFlag FLAG = LightFlag.NONE
            .with(f -> f.on(true).position(new Vec3(0.3, 1.5, 0.3)).rotation(new Vec3(80, 10, 0)).width(2).height(2).softness(0.3));
    private static final LightFilter FILTER = LightFilter.NONE.with(f -> f.shape(FilterShape.SPHERE).size(new Vec3(3, 2, 2)).softness(0.5));

    private static void assertNoRay(StudioRenderer studio, UnaryOperator<Light> edit) {
        UpdateResult update = studio.edit(edit::apply);
        assertThat(update.rays().total()).as(update.plan().description()).isZero();
        assertThat(studio.renderer().film().hasSameBits(new ReferenceTracer(studio.scene()).trace())).isTrue();
    }

    private static void edit(Scene scene) {
        try (var studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene)) {
            assertNoRay(studio, light -> light.withFlag(FLAG));
            assertNoRay(studio, light -> light.withFlag(FLAG.withPosition(new Vec3(0, 2, 0)).withDensity(0.7)));
            assertNoRay(studio, light -> light.withFilter(FILTER));
            assertNoRay(studio, light -> light.withFilter(FILTER.withShape(FilterShape.RAMP)));
            assertNoRay(studio, light -> light.withFilter(FILTER.withInverted(true)).withFlag(LightFlag.NONE));
            assertNoRay(studio, light -> light.withFilter(LightFilter.NONE));
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void edits_castNoRay(LightType type) {
        edit(StudioScene.of(type));
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void edits_inFog_castNoRay(LightType type) {
        Scene scene = StudioScene.of(type);
        edit(scene.withWorld(scene.world().withFog(Fog.NONE.withDensity(0.1).withSize(new Vec3(9, 9, 9)))));
    }
}
