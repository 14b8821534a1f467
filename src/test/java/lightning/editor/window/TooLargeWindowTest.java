package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

/** Requests a picture that exceeds any memory. */
@OwnEditor
class TooLargeWindowTest extends EditorFixture {
    @Test
    void memoryError_inStatus_omitsCommandLineOptions() {
        PictureSettings huge = new PictureSettings(16384, 16384, 2).withSampling(new SamplingSettings(AntialiasMode.EVERY, 8));
        WaitForAsyncUtils.asyncFx(() -> {
            model().editor().edit(scene -> new EditOutcome.Applied(scene.withPicture(huge)));
            model().commands().run(Command.GO);
        });
        waitFor("the refusal is shown", () -> text("status").startsWith("Too large"));
        assertThat(text("status")).contains("GB is available; it would fit with a size of ").doesNotContain("--");
    }
}
