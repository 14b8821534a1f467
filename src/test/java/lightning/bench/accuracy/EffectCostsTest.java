package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.relight.tile.Options;
import lightning.render.trace.HitRows;
import lightning.sample.StudioScene;
import lightning.scene.LightType;
import lightning.scene.Scene;
import lightning.scene.effects.Effect;
import org.junit.jupiter.api.Test;

/** What effects take: bytes and rays, which no noise changes. */
class EffectCostsTest {
    private static final Options OPTIONS = Options.DEFAULT.withThreads(1);

    private static EffectCosts of(Scene scene) {
        Scene after = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withIntensity(0.5));
        return EffectCosts.of(scene, after, OPTIONS, 1, Progress.NONE);
    }

    private static EffectCost cost(EffectCosts costs, Effect effect) {
        return costs.effects().get(Effect.ALL.indexOf(effect));
    }

    @Test
    void everyEffect_isListedOnce() {
        EffectCosts costs = of(StudioScene.of(LightType.POINT));
        assertThat(costs.effects()).extracting(EffectCost::effect).containsExactlyElementsOf(Effect.ALL);
        assertThat(costs.plan()).isEqualTo("key: weight, reflections");
        assertThat(costs.bytes()).isPositive();
    }

    @Test
    void measurableEffects_areThoseThatAreMeasured() {
        Scene scene = StudioScene.of(LightType.POINT);
        assertThat(of(scene).effects()).filteredOn(EffectCost::measured).hasSize(EffectCosts.measurable(scene));
    }

    @Test
    void unmeasuredEffect_wasTooLargeUnlessNobodyCanForceIt() {
        EffectCosts costs = of(StudioScene.of(LightType.POINT));
        assertThat(costs.tooLarge()).isEmpty();
        List<EffectCost> lost = costs.effects().stream().map(c -> new EffectCost(c.effect(), c.callers(),
                c.measured() && c.effect() != Effect.ANTIALIASING, 0, 0, 0, 0, 0, c.rays())).toList();
        assertThat(new EffectCosts(costs.first(), costs.update(), costs.plan(), costs.bytes(), lost).tooLarge())
                .containsExactly(Effect.ANTIALIASING);
    }

    @Test
    void shadowsInUse_takeTheirRays() {
        EffectCost shadows = cost(of(StudioScene.of(LightType.POINT)), Effect.SHADOWS);
        assertThat(shadows.inUse()).isTrue();
        assertThat(shadows.callers()).containsExactly(StudioScene.KEY);
        assertThat(shadows.rays().shadow()).isPositive();
        assertThat(shadows.rays().eye()).isZero();
    }

    @Test
    void reflectionsInUse_takeMirroredRaysAndBytes() {
        EffectCost mirrors = cost(of(StudioScene.of(LightType.POINT)), Effect.REFLECTION);
        assertThat(mirrors.rays().mirrored()).isPositive();
        assertThat(mirrors.bytes()).isPositive();
    }

    @Test
    void absentTexture_savesAColourARow() {
        Scene scene = StudioScene.of(LightType.POINT);
        EffectCost textures = cost(of(scene), Effect.TEXTURES);
        assertThat(textures.inUse()).isFalse();
        assertThat(textures.measured()).isTrue();
        // Twelve bytes for each row of each level, which are rounded up to sixteen rows a tile.
        assertThat(textures.bytes()).isPositive().isEqualTo(textures.bytes() / (12 * 16) * 12 * 16);
        assertThat(textures.rays().all()).isZero();
        assertThat(HitRows.padded(1)).isEqualTo(16);
    }

    @Test
    void absentSamples_saveRays() {
        EffectCost finer = cost(of(StudioScene.of(LightType.POINT)), Effect.ANTIALIASING);
        assertThat(finer.inUse()).isFalse();
        assertThat(finer.rays().eye()).isPositive();
        assertThat(finer.bytes()).isPositive();
    }

    @Test
    void absentKindsOfLightsAndShapes_cannotBeForced() {
        EffectCosts costs = of(StudioScene.of(LightType.POINT));
        assertThat(cost(costs, Effect.of("spot-lights")).measured()).isFalse();
        assertThat(cost(costs, Effect.of("cylinders")).measured()).isFalse();
    }

    @Test
    void cancelled_stops() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Progress stop = new Progress() {
            @Override
            public void tiles(int done, int total) {}

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        assertThatThrownBy(() -> EffectCosts.of(scene, scene, OPTIONS, 1, stop)).isInstanceOf(CancellationException.class);
    }
}
