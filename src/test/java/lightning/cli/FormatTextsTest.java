package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.Command;
import lightning.format.MeshFormat;
import lightning.format.image.ImageFormat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Help texts list every file format; their words are constants that are not derived from the formats. */
class FormatTextsTest {

    @ParameterizedTest
    @EnumSource
    void everyMeshFormat_isListedInOpenHelp(MeshFormat format) {
        assertThat(CliResult.run("import", "--help").out()).contains(format.title());
        assertThat(CliResult.run("edit", "--help").out()).contains(format.title());
        assertThat(Command.LOAD_FILE.help()).contains(format.title());
    }

    @Test
    void everyMeshExtension_isListedInImportHelp() {
        assertThat(CliResult.run("import", "--help").out()).contains(MeshFormat.allExtensions());
        CliResult.run("edit", "a.txt").assertRejected(".jen, .ply, .obj, .nff, .gltf, .glb");
    }

    @Test
    void everyPictureFormat_isListedInOutputHelp() {
        assertThat(CliResult.run("render", "--help").out())
                .contains(ImageFormat.written().stream().map(ImageFormat::extension).toList());
    }
}
