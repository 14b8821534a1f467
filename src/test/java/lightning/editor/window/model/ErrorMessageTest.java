package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Test;

class ErrorMessageTest {
    @Test
    void importError_usesItsOwnMessage() {
        assertThat(ErrorMessage.of(new MeshException(Path.of("a.gltf"), "buffers[0].uri", "there is no file")))
                .isEqualTo("a.gltf: buffers[0].uri: there is no file");
    }

    @Test
    void fileInsteadOfFolder_isReported() {
        assertThat(ErrorMessage.of(new NotDirectoryException("out"))).isEqualTo("out: is not a folder");
        assertThat(ErrorMessage.of(new FileAlreadyExistsException("out"))).isEqualTo("out: already exists and is not a folder");
    }

    @Test
    void ioErrorWithoutMessage_isNotInternalError() {
        assertThat(ErrorMessage.of(new IOException())).isEqualTo("IOException");
    }

    @Test
    void unexpectedException_isInternalError() {
        assertThat(ErrorMessage.of(new IllegalStateException("x"))).startsWith("Internal error");
    }
}
