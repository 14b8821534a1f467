package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class PreviewCostTest {
    @Test
    void measuredDraw_reflectsAndCastsShadowsOfOneLight() throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 40 30  depth 2 }
                material mirror { diffuse 0.5 0.5 0.5  reflective 0.4 0.4 0.4 }
                sphere ball { material mirror }
                plane floor { material mirror  at 0 -1 0  scale 9 1 9 }
                light a point { at 0 5 5 }
                light b point { at 3 5 5 }
                """, "preview.jen", Path.of("")).scene();
        try (var preview = new PreviewCost.Preview(1, Progress.NONE)) {
            RayCounts one = preview.draw(scene, "a").rays();
            assertThat(one.mirrored()).isPositive();
            assertThat(one.shadow()).isPositive();
        }
        try (var preview = new PreviewCost.Preview(1, Progress.NONE)) {
            assertThat(preview.draw(scene, "").rays().shadow()).isZero();
        }
    }
}
