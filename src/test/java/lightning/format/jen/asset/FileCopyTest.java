package lightning.format.jen.asset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** External images are copied only to where scenes find them. */
class FileCopyTest {
    @TempDir
    Path root;
    private Path scene;
    private Path elsewhere;

    @BeforeEach
    void folders() throws IOException {
        scene = Files.createDirectories(root.toRealPath().resolve("a/b/project/scene"));
        elsewhere = Files.createDirectories(root.toRealPath().resolve("elsewhere"));
    }

    /** Returns an image of one pixel whose gray depends on the content. */
    private static byte[] bytes(String content) throws IOException {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x010101 * content.charAt(0));
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private Path picture(String name, String content) throws IOException {
        return Files.write(elsewhere.resolve(name), bytes(content));
    }

    @Test
    void image_isCopiedIntoTexturesNextToScene() throws IOException {
        assertThat(FileCopy.copyToScene(FileKind.TEXTURE, picture("wood.png", "a"), scene, false))
                .isEqualTo(new FileCopy.Copied("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).hasBinaryContent(bytes("a"));
        assertThat(FileKind.TEXTURE.fileNames(scene)).containsExactly("wood.png");
    }

    @Test
    void parentTexturesFolder_receivesTheCopy() throws IOException {
        Path textures = Files.createDirectories(scene.resolveSibling("textures"));
        FileCopy.copyToScene(FileKind.TEXTURE, picture("wood.jpg", "a"), scene, false);
        assertThat(textures.resolve("wood.jpg")).hasBinaryContent(bytes("a"));
        assertThat(scene.resolve("textures")).as("another such folder would hide the first").doesNotExist();
    }

    @Test
    void differentFile_isOverwrittenOnlyIfAllowed() throws IOException {
        FileCopy.copyToScene(FileKind.TEXTURE, picture("wood.png", "a"), scene, false);
        Path other = picture("wood.png", "b");
        assertThat(FileCopy.copyToScene(FileKind.TEXTURE, other, scene, false)).isEqualTo(new FileCopy.NameConflict("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).hasBinaryContent(bytes("a"));
        assertThat(FileCopy.copyToScene(FileKind.TEXTURE, other, scene, true)).isEqualTo(new FileCopy.Copied("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).hasBinaryContent(bytes("b"));
    }

    @Test
    void alreadyFoundImage_isNotCopied() throws IOException {
        Path existing = Files.write(scene.resolve("wood.png"), bytes("a"));
        assertThat(FileCopy.copyToScene(FileKind.TEXTURE, existing, scene, false)).isEqualTo(new FileCopy.Copied("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).doesNotExist();
    }

    @Test
    void unreadableFile_isRejectedWithoutWriting() throws IOException {
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.TEXTURE, picture("wood.txt", "a"), scene, true))
                .withMessage("a texture must be a PNG, JPEG, Radiance HDR or OpenEXR file, was 'wood.txt'");
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.TEXTURE, picture("w#od.png", "a"), scene, true))
                .withMessageStartingWith("texture must be a file name of 1 to 200 letters");
        assertThat(scene.resolve("textures")).doesNotExist();
    }

    @Test
    void damagedFile_isRejectedWithoutWriting() throws IOException {
        byte[] valid = bytes("a");
        Path truncated = Files.write(elsewhere.resolve("torn.png"), Arrays.copyOf(valid, valid.length / 2));
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.TEXTURE, truncated, scene, true))
                .withMessageStartingWith("texture 'torn.png' cannot be decoded");
        Path environment = Files.writeString(elsewhere.resolve("sky.hdr"), "#?RADIANCE\n");
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.ENVIRONMENT, environment, scene, true))
                .withMessageContaining("expected the end of the header, found the end of the file");
        Path profile = Files.writeString(elsewhere.resolve("lamp.ies"), "no such thing");
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.PROFILE, profile, scene, true))
                .withMessageContaining("lamp.ies");
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.ENVIRONMENT, truncated, scene, true))
                .withMessage("an environment must be a Radiance HDR or OpenEXR file, was 'torn.png'");
        assertThat(scene.resolve("textures")).doesNotExist();
    }

    @Test
    void linkOutOfTheFolder_isNotFollowed() throws IOException {
        Path outside = Files.createDirectories(root.resolve("outside"));
        Files.createSymbolicLink(scene.resolve("textures"), outside);
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.TEXTURE, picture("wood.png", "a"), scene, true))
                .withMessageStartingWith("the texture folder must not be a link");
        Files.delete(scene.resolve("textures"));
        Path victim = Files.writeString(outside.resolve("victim.png"), "v");
        Files.createSymbolicLink(Files.createDirectories(scene.resolve("textures")).resolve("wood.png"), victim);
        assertThatIllegalArgumentException().isThrownBy(() -> FileCopy.copyToScene(FileKind.TEXTURE, picture("wood.png", "a"), scene, true))
                .withMessageContaining("is a link");
        assertThat(victim).hasContent("v");
    }
}
