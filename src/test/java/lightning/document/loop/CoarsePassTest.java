package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class CoarsePassTest {
    private static final float LIGHT = 0.5f;

    /** A wall that no light shines on. */
    private static Scene wall(String indirect) throws JenException {
        return JenReader.read("jen 1\npicture { size 640 480 " + indirect + " }\ncamera { from 0 0 4  to 0 0 0 }\nworld { ambience 0 }\n"
                + "material white { diffuse 1 1 1 }\nplane wall { material white  rotate 90 0 0  scale 9 1 9 }\n", "wall", Path.of("."))
                .scene();
    }

    private static List<Film> films(Scene scene) {
        List<Film> shown = new ArrayList<>();
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            var pass = new CoarsePass(RenderedScenes.of(scene), renderer::prepare, renderer.options(), shown::add, Progress.NONE);
            CoarsePicture coarse = CoarsePicture.trace(RenderedScenes.of(scene), 80, 60, renderer::geometryOf, 1, Progress.NONE);
            float[] gray = new float[3 * 32 * 24];
            Arrays.fill(gray, LIGHT);
            pass.offerLit(Film.ofScanlines(32, 24, gray));
            pass.show(coarse);
            assertThat(coarse.film().red(20, 20)).as("direct light alone").isZero();
        }
        return shown;
    }

    @Test
    void imagesAfterASmallPicture_haveItsLight() throws JenException {
        List<Film> shown = films(wall("indirect {}"));
        assertThat(shown.getLast().width()).isEqualTo(80);
        assertThat(shown.getLast().red(20, 20)).isEqualTo(LIGHT);
    }

    @Test
    void imagesWithoutIndirectLight_areTraced() throws JenException {
        assertThat(films(wall("")).getLast().red(20, 20)).isZero();
    }
}
