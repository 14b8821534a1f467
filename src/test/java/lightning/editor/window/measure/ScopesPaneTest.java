package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import javafx.scene.control.Slider;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.render.image.Scopes;
import org.junit.jupiter.api.Test;

class ScopesPaneTest extends EditorFixture {
    private int[] pixels(String id) {
        Image image = robot.lookup("#" + id).<ImageView>query().getImage();
        if (image == null) {
            return new int[0];
        }
        int[] pixels = new int[(int) (image.getWidth() * image.getHeight())];
        image.getPixelReader().getPixels(0, 0, (int) image.getWidth(), (int) image.getHeight(), PixelFormat.getIntArgbInstance(), pixels, 0,
                (int) image.getWidth());
        return pixels;
    }

    private Scopes expected() {
        return Scopes.of(model().picture().frame().film(), model().picture().viewProperty().get());
    }

    @Test
    void scopes_followPictureAndExposure() {
        robot.interact(() -> model().commands().run(Command.SCOPES));
        waitFor("the waveform is shown", () -> Arrays.equals(pixels("waveform"), expected().waveformPixels()));
        assertThat(pixels("histogram")).isEqualTo(expected().histogramPixels(160));
        int[] before = pixels("histogram");
        robot.interact(() -> robot.lookup("#exposure").<Slider>query().setValue(1));
        waitFor("the histogram is updated", () -> Arrays.equals(pixels("histogram"), expected().histogramPixels(160)));
        assertThat(pixels("histogram")).isNotEqualTo(before);
    }
}
