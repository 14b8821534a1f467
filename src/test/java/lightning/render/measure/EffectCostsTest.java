package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.trace.HitRows;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

/** Costs of effects in bytes and rays, which are deterministic. */
class EffectCostsTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private static EffectCosts measure(Scene scene) {
        Scene after = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withIntensity(0.5));
        return EffectCosts.of(scene, after, OPTIONS, 1, Progress.NONE);
    }

    private static EffectCost cost(EffectCosts costs, RenderEffect effect) {
        return costs.effects().get(RenderEffect.ALL.indexOf(effect));
    }

    @Test
    void everyEffect_isListedOnce() {
        EffectCosts costs = measure(StudioScene.of(LightType.POINT));
        assertThat(costs.effects()).extracting(EffectCost::effect).containsExactlyElementsOf(RenderEffect.ALL);
        assertThat(costs.plan()).isEqualTo("key: weight, reflections");
        assertThat(costs.bytes()).isPositive();
    }

    @Test
    void measurableCount_matchesMeasuredEffects() {
        Scene scene = StudioScene.of(LightType.POINT);
        assertThat(measure(scene).effects()).filteredOn(EffectCost::measured).hasSize(EffectCosts.measurableCount(scene));
    }

    @Test
    void unmeasuredForcibleEffect_wasTooLarge() {
        EffectCosts costs = measure(StudioScene.of(LightType.POINT));
        assertThat(costs.effectsOverMemory()).isEmpty();
        List<EffectCost> lost = costs.effects().stream().map(c -> new EffectCost(c.effect(), c.callers(),
                c.measured() && c.effect() != RenderEffect.ANTIALIASING, 0, 0, 0, 0, 0, c.rays())).toList();
        assertThat(new EffectCosts(costs.first(), costs.update(), costs.plan(), costs.bytes(), lost).effectsOverMemory())
                .containsExactly(RenderEffect.ANTIALIASING);
    }

    @Test
    void shadowsInUse_costTheirRays() {
        EffectCost shadows = cost(measure(StudioScene.of(LightType.POINT)), RenderEffect.SHADOWS);
        assertThat(shadows.inUse()).isTrue();
        assertThat(shadows.callers()).containsExactly(StudioScene.KEY);
        assertThat(shadows.rays().shadow()).isPositive();
        assertThat(shadows.rays().eye()).isZero();
    }

    @Test
    void reflectionsInUse_costRaysAndBytes() {
        EffectCost mirrors = cost(measure(StudioScene.of(LightType.POINT)), RenderEffect.REFLECTION);
        assertThat(mirrors.rays().mirrored()).isPositive();
        assertThat(mirrors.bytes()).isPositive();
    }

    @Test
    void absentTexture_savesOneColorPerRow() {
        Scene scene = StudioScene.of(LightType.POINT);
        EffectCost textures = cost(measure(scene), RenderEffect.TEXTURES);
        assertThat(textures.inUse()).isFalse();
        assertThat(textures.measured()).isTrue();
        // Twelve bytes per row of each level, rounded up to sixteen rows per tile.
        assertThat(textures.bytes()).isPositive().isEqualTo(textures.bytes() / (12 * 16) * 12 * 16);
        assertThat(textures.rays().total()).isZero();
        assertThat(HitRows.paddedLength(1)).isEqualTo(16);
    }

    @Test
    void absentSamples_saveRays() {
        EffectCost finer = cost(measure(StudioScene.of(LightType.POINT)), RenderEffect.ANTIALIASING);
        assertThat(finer.inUse()).isFalse();
        assertThat(finer.rays().eye()).isPositive();
        assertThat(finer.bytes()).isPositive();
    }

    @Test
    void absentKindsOfLightsAndShapes_cannotBeForced() {
        EffectCosts costs = measure(StudioScene.of(LightType.POINT));
        assertThat(cost(costs, RenderEffect.of("spot-lights")).measured()).isFalse();
        assertThat(cost(costs, RenderEffect.of("cylinders")).measured()).isFalse();
    }

    @Test
    void canceled_stops() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Progress stop = new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return true;
            }
        };
        assertThatThrownBy(() -> EffectCosts.of(scene, scene, OPTIONS, 1, stop)).isInstanceOf(CancellationException.class);
    }
}
