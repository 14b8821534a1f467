package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;

class SentenceTest {
    @Test
    void fileOfAnotherProgram_isToldInItsOwnWords() {
        assertThat(Sentence.of(new MeshException(Path.of("a.gltf"), "buffers[0].uri", "there is no file")))
                .isEqualTo("a.gltf: buffers[0].uri: there is no file");
    }

    @Test
    void folderThatIsAFile_isToldAsThat() {
        assertThat(Sentence.of(new NotDirectoryException("out"))).isEqualTo("out: is no folder");
        assertThat(Sentence.of(new FileAlreadyExistsException("out"))).isEqualTo("out: is there already and is no folder");
    }

    @Test
    void fileErrorWithoutWords_isNoErrorOfTheProgram() {
        assertThat(Sentence.of(new IOException())).isEqualTo("IOException");
    }

    @Test
    void whatNobodyForesaw_isAnErrorOfTheProgram() {
        assertThat(Sentence.of(new IllegalStateException("x"))).startsWith("An error of the program itself");
    }
}
