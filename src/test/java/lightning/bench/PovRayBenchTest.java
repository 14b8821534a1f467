package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class PovRayBenchTest {
    private final Scene scene = GeneratedScenes.of(1, new PictureSize(40, 30), 30, 3, 2);

    @Test
    void flatColors_differPerShape() {
        Scene flat = FlatColorScene.of(scene);
        Set<Object> colors = new HashSet<>();
        for (PlacedShape shape : flat.placedShapes()) {
            colors.add(shape.material().ambient());
        }
        assertThat(colors).hasSize(30);
        assertThat(flat.lights()).isEmpty();
        assertThat(flat.placedShapes()).extracting(PlacedShape::toWorld)
                .isEqualTo(scene.placedShapes().stream().map(PlacedShape::toWorld).toList());
    }

    @Test
    void flatPicture_hasMultiplesOfStep() {
        for (int pixel : ViewTransform.DEFAULT.toPixels(new ReferenceTracer(FlatColorScene.of(scene)).trace())) {
            assertThat((pixel & 0xFF) % FlatColorScene.STEP).isZero();
            assertThat((pixel >> 8 & 0xFF) % FlatColorScene.STEP).isZero();
            assertThat((pixel >> 16 & 0xFF) % FlatColorScene.STEP).isZero();
        }
    }

    @Test
    void agreement_isShareOfEqualPixels() {
        Film ours = Film.black(4, 1);
        Film theirs = Film.black(4, 1);
        ours.red(0)[0] = ViewTransform.linear(17);
        theirs.red(0)[0] = ViewTransform.linear(20);
        ours.green(0)[1] = ViewTransform.linear(34);
        theirs.green(0)[1] = ViewTransform.linear(51);
        theirs.blue(0)[2] = ViewTransform.linear(9);
        assertThat(PovRayBench.agreement(ours, theirs)).isEqualTo(0.5);
        assertThat(PovRayBench.agreement(ours, ours)).isEqualTo(1);
    }
}
