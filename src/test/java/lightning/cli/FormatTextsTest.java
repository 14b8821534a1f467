package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import lightning.editor.document.Command;
import lightning.format.MeshFormat;
import lightning.format.picture.PictureFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Help that people read names every format: its words are constants, which the formats cannot make. */
class FormatTextsTest {

    @ParameterizedTest
    @EnumSource
    void everyMeshFormat_isNamedWhereFilesAreOpened(MeshFormat format) {
        assertThat(Cli.run("import", "--help").out()).contains(format.title());
        assertThat(Cli.run("edit", "--help").out()).contains(format.title());
        assertThat(Command.LOAD_FILE.help()).contains(format.title());
    }

    @Test
    void everyEndingOfMeshes_isNamedWhereFilesAreImported() {
        assertThat(Cli.run("import", "--help").out()).contains(MeshFormat.allEndings());
        Cli.run("edit", "a.txt").isRefusedSaying(".jen, .ply, .obj, .nff, .gltf, .glb");
    }

    @Test
    void everyPictureFormat_isNamedWherePicturesAreWritten() {
        assertThat(Cli.run("render", "--help").out()).contains(Arrays.stream(PictureFormat.values()).map(PictureFormat::ending).toList());
    }
}
