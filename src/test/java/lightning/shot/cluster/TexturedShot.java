package lightning.shot.cluster;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.shot.ShotRevision;

/** Shot with a textured ball and a moving camera, which needs an image file besides the scene file. */
final class TexturedShot {
    private TexturedShot() {}

    /**
     * Writes the scene file and its image, and reads them.
     *
     * @param width pixels of the picture, as {@code height}
     * @param last  last frame; the first is 1
     */
    static ShotRevision write(Path folder, BufferedImage image, int width, int height, int last) throws Exception {
        ImageIO.write(image, "png", Files.createDirectories(folder.resolve("textures")).resolve("spots.png").toFile());
        JenDocument document = JenReader.read(Files.writeString(folder.resolve("textured.jen"), """
                jen 1
                camera { from 0 1 6 to 0 0 0 }
                material spotted { texture "spots.png" }
                sphere ball { material spotted }
                light lamp point { at 2 4 5 intensity 1 }
                """ + "picture { size " + width + " " + height + " }\n"
                + "shot { frames 1 " + last + " camera { from { 1 0 1 6 " + last + " 2 1 5 } } }"));
        return new ShotRevision(document.scene(), document.shot().orElseThrow());
    }
}
