package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.scene.Antialias;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

/** A picture that no memory holds, asked for in the editor. */
class TooLargeWindowTest extends EditorDesk {
    @Test
    void refusal_isInTheStatusWithoutOptionsOfTheCommandLine() {
        Picture huge = new Picture(16384, 16384, 2).withSampling(new Sampling(Antialias.EVERY, 8));
        WaitForAsyncUtils.asyncFx(() -> {
            model().editor().edit(scene -> new Change.To(scene.withPicture(huge)));
            model().commands().run(Command.GO);
        });
        waitFor("the refusal is told", () -> text("status").startsWith("This is too large"));
        assertThat(text("status")).contains("GB; it would fit with a size of ").doesNotContain("--");
    }
}
