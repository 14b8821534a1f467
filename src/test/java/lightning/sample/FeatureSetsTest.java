package lightning.sample;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import lightning.render.relight.SceneView;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class FeatureSetsTest {
    /** Counts without the code under test: of n features, k together, and not the exclusive pairs with any others. */
    @ParameterizedTest
    @CsvSource({"2, 25", "3, 160"})
    void everyCombination_isInASet(int strength, int most) {
        List<Set<SceneFeature>> sets = FeatureSets.covering(strength);
        SceneFeature[] all = SceneFeature.values();
        int combinations = 0;
        for (int a = 0; a < all.length; a++) {
            for (int b = a + 1; b < all.length; b++) {
                for (int c = strength == 2 ? b : b + 1; c < (strength == 2 ? b + 1 : all.length); c++) {
                    List<SceneFeature> together = List.of(all[a], all[b], all[c]);
                    if (!all[a].excludes(all[b]) && !all[a].excludes(all[c]) && !all[b].excludes(all[c])) {
                        combinations++;
                        assertThat(sets).as("%s", together).anyMatch(set -> set.containsAll(together));
                    }
                }
            }
        }
        int n = all.length;
        assertThat(combinations).isEqualTo(strength == 2 ? n * (n - 1) / 2 - 2 : n * (n - 1) * (n - 2) / 6 - 2 * (n - 2));
        assertThat(sets).hasSizeLessThanOrEqualTo(most);
    }

    @Test
    void exclusiveFeatures_areInNoSet() {
        assertThat(FeatureSets.covering(2)).noneMatch(set -> set.stream().anyMatch(one -> set.stream().anyMatch(one::excludes)));
    }

    /** A feature that changes nothing tests nothing. */
    @ParameterizedTest
    @EnumSource
    void everyFeature_changesThePicture(SceneFeature feature) {
        assertThat(pixels(SceneFeature.scene(List.of(feature)))).isNotEqualTo(pixels(SceneFeature.scene(List.of())));
    }

    private static int[] pixels(Scene scene) {
        return SceneView.of(scene).toPixels(new ReferenceTracer(scene).trace());
    }
}
