package lightning.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures from elsewhere come to where scenes find them, and nowhere else. */
class PictureCopyTest {
    @TempDir
    Path root;
    private Path scene;
    private Path elsewhere;

    @BeforeEach
    void folders() throws IOException {
        scene = Files.createDirectories(root.toRealPath().resolve("a/b/project/scene"));
        elsewhere = Files.createDirectories(root.toRealPath().resolve("elsewhere"));
    }

    private Path picture(String name, String content) throws IOException {
        return Files.writeString(elsewhere.resolve(name), content);
    }

    @Test
    void picture_isCopiedIntoTheTexturesBesideTheScene() throws IOException {
        assertThat(PictureCopy.bring(picture("wood.png", "a"), scene, false)).isEqualTo(new PictureCopy.Brought("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).hasContent("a");
        assertThat(PropertyEdit.textures(scene)).containsExactly("wood.png");
    }

    @Test
    void texturesOfAFolderAbove_areThoseThatGetIt() throws IOException {
        Path textures = Files.createDirectories(scene.resolveSibling("textures"));
        PictureCopy.bring(picture("wood.jpg", "a"), scene, false);
        assertThat(textures.resolve("wood.jpg")).hasContent("a");
        assertThat(scene.resolve("textures")).as("another such folder would hide the first").doesNotExist();
    }

    @Test
    void anotherPictureOfThatName_isWrittenOverOnlyWhereThatIsAllowed() throws IOException {
        PictureCopy.bring(picture("wood.png", "a"), scene, false);
        Path other = picture("wood.png", "b");
        assertThat(PictureCopy.bring(other, scene, false)).isEqualTo(new PictureCopy.Taken("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).hasContent("a");
        assertThat(PictureCopy.bring(other, scene, true)).isEqualTo(new PictureCopy.Brought("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).hasContent("b");
    }

    @Test
    void pictureThatTheSceneFindsAlready_staysWhereItIs() throws IOException {
        Path there = Files.writeString(scene.resolve("wood.png"), "a");
        assertThat(PictureCopy.bring(there, scene, false)).isEqualTo(new PictureCopy.Brought("wood.png"));
        assertThat(scene.resolve("textures/wood.png")).doesNotExist();
    }

    @Test
    void whatNoSceneCouldRead_isRefusedAndNothingIsWritten() throws IOException {
        assertThatIllegalArgumentException().isThrownBy(() -> PictureCopy.bring(picture("wood.txt", "a"), scene, true))
                .withMessage("a texture must be a PNG or JPEG file, was 'wood.txt'");
        assertThatIllegalArgumentException().isThrownBy(() -> PictureCopy.bring(picture("w#od.png", "a"), scene, true))
                .withMessageStartingWith("texture must be a file name of 1 to 200 letters");
        assertThat(scene.resolve("textures")).doesNotExist();
    }

    @Test
    void linkOutOfTheFolder_isNotFollowed() throws IOException {
        Path outside = Files.createDirectories(root.resolve("outside"));
        Files.createSymbolicLink(scene.resolve("textures"), outside);
        assertThatIllegalArgumentException().isThrownBy(() -> PictureCopy.bring(picture("wood.png", "a"), scene, true))
                .withMessageStartingWith("the folder of textures must be no link");
        Files.delete(scene.resolve("textures"));
        Path victim = Files.writeString(outside.resolve("victim.png"), "v");
        Files.createSymbolicLink(Files.createDirectories(scene.resolve("textures")).resolve("wood.png"), victim);
        assertThatIllegalArgumentException().isThrownBy(() -> PictureCopy.bring(picture("wood.png", "a"), scene, true))
                .withMessageContaining("is a link");
        assertThat(victim).hasContent("v");
    }
}
