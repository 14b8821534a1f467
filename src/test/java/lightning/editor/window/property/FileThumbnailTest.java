package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import lightning.format.jen.ManyScans;
import lightning.format.jen.asset.FileKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileThumbnailTest {
    @TempDir
    private Path folder;

    private Path picture(Path at, int width, int height) throws IOException {
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x123456);
        Files.createDirectories(at.getParent());
        ImageIO.write(image, "png", at.toFile());
        return at;
    }

    @Test
    void texture_isScaledDownWithItsAspect() throws IOException {
        picture(folder.resolve("scene/textures/wide.png"), 800, 200);
        FileThumbnail small = FileThumbnail.of(FileKind.TEXTURE, folder.resolve("scene"), "wide.png").orElseThrow();
        assertThat(small.width()).isEqualTo(40);
        assertThat(small.height()).isEqualTo(10);
        assertThat(small.pixels()[0]).isEqualTo(0xFF123456);
    }

    @Test
    void linearImage_isExposed() throws IOException {
        var bytes = new ByteArrayOutputStream();
        bytes.writeBytes("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 50 +X 100\n".getBytes(StandardCharsets.ISO_8859_1));
        for (int i = 0; i < 100 * 50; i++) {
            // Far above white on the left, half as bright on the right.
            bytes.writeBytes(new byte[] {(byte) 128, 64, 64, (byte) (i % 100 < 50 ? 140 : 139)});
        }
        Files.write(folder.resolve("sky.hdr"), bytes.toByteArray());
        for (FileKind kind : List.of(FileKind.ENVIRONMENT, FileKind.TEXTURE)) {
            FileThumbnail small = FileThumbnail.of(kind, folder, "sky.hdr").orElseThrow();
            assertThat(small.width()).isEqualTo(50);
            assertThat(small.height()).isEqualTo(25);
            int left = small.pixels()[0];
            assertThat(left >>> 24).isEqualTo(255);
            assertThat(left >> 16 & 255).isBetween(100, 250).isGreaterThan(small.pixels()[49] >> 16 & 255);
        }
        Files.writeString(folder.resolve("text.exr"), "no picture");
        assertThat(FileThumbnail.of(FileKind.TEXTURE, folder, "text.exr")).isEmpty();
    }

    @Test
    void textureInParentFolder_isFound() throws IOException {
        picture(folder.resolve("textures/above.png"), 80, 80);
        Path scene = Files.createDirectories(folder.resolve("scenes"));
        assertThat(FileThumbnail.of(FileKind.TEXTURE, scene, "above.png")).isPresent();
    }

    @Test
    void pictureOutsideTheFolder_isNotRead() throws IOException {
        Path secret = picture(folder.resolve("secret.png"), 8, 8);
        Path scene = Files.createDirectories(folder.resolve("scene"));
        Files.createSymbolicLink(scene.resolve("link.png"), secret);
        assertThat(FileThumbnail.of(FileKind.TEXTURE, scene, "link.png")).isEmpty();
        assertThat(FileThumbnail.of(FileKind.TEXTURE, scene, "../secret.png")).isEmpty();
    }

    @Test
    void jpegWithManyScans_hasNoThumbnail() throws IOException {
        Files.write(folder.resolve("few.jpg"), ManyScans.jpeg(16, 16, 0));
        Files.write(folder.resolve("many.jpg"), ManyScans.jpeg(16, 16, 300));
        assertThat(FileThumbnail.of(FileKind.TEXTURE, folder, "few.jpg")).isPresent();
        assertThat(FileThumbnail.of(FileKind.TEXTURE, folder, "many.jpg")).isEmpty();
    }

    @Test
    void invalidPicture_hasNoThumbnail() throws IOException {
        Files.writeString(folder.resolve("text.png"), "no picture");
        assertThat(FileThumbnail.of(FileKind.TEXTURE, folder, "text.png")).isEmpty();
        assertThat(FileThumbnail.of(FileKind.TEXTURE, folder, "missing.png")).isEmpty();
    }
}
