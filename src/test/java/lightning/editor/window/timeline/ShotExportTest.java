package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.document.OpenDocument;
import lightning.render.image.ViewTransform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ShotExportTest {
    @TempDir
    private Path folder;

    @Test
    void frameThatIsATextureOfTheScene_isNotReplaced() throws Exception {
        Path texture = Files.copy(Path.of("textures/checker.png"), folder.resolve("walk-0001.png"));
        Path scene = Files.writeString(folder.resolve("a.jen"),
                "jen 1\npicture { size 8 6 }\nmaterial m { texture \"walk-0001.png\" }\nsphere s { material m }\n"
                        + "shot { frames 0 1 rate 24 }\n");
        OpenDocument document = OpenDocument.open(scene);
        byte[] before = Files.readAllBytes(texture);
        var export = new ShotExport(document.content(), 0, 1, ShotFormat.PNG, ViewTransform.DEFAULT, folder, "walk", document.inputs());
        assertThatIOException().isThrownBy(() -> export.write(Progress.NONE, _ -> {}))
                .withMessageContaining("walk-0001.png: is read by this command and would be replaced");
        assertThat(texture).hasBinaryContent(before);
        assertThat(folder.resolve("walk-0000.png")).doesNotExist();
    }
}
