package lightning.editor.loop;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.file.ContentHash;
import lightning.format.jen.JenDocument;
import lightning.format.jen.ReferencedFiles;
import lightning.scene.Scene;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.MaterialAttribute;

/**
 * Names under which the picture of a scene is kept: hashes of everything that determines it. Those are the program, the scene's text, the
 * sizes of its images, and the content of the files that it names.
 *
 * @param text  hash of the program, the text and the sizes
 * @param files hash of the files
 */
record PictureKey(ContentHash text, ContentHash files) {
    /** Scenes with more objects have long texts. */
    private static final int MAX_SHAPES = 20_000;

    /** Returns the hash of the program and a scene's text; empty if the scene is too large. */
    static Optional<ContentHash> textOf(Scene scene, String program) {
        if (scene.stage().shapes().size() > MAX_SHAPES) {
            return Optional.empty();
        }
        String all = program + '\0' + JenDocument.of(scene).text() + '\0' + imageSizes(scene);
        return Optional.of(ContentHash.of(all.getBytes(StandardCharsets.UTF_8)));
    }

    /** Returns the sizes of all images: a reader reduces large ones, by how many others there are. */
    private static String imageSizes(Scene scene) {
        Stream<Texture> ofMaterials = scene.materials().stream()
                .flatMap(material -> MaterialAttribute.MAPS.stream().flatMap(map -> map.get(material).stream())).map(TextureMap::image);
        Stream<Texture> ofLights = scene.lights().stream().flatMap(light -> Stream.concat(light.gobo().stream().map(Gobo::image),
                light.texture().stream().map(LightTexture::image)));
        Stream<String> textures = Stream.concat(ofMaterials, ofLights).map(image -> image.width() + "x" + image.height());
        Stream<String> environments =
                Stream.concat(scene.world().environment().stream(), scene.world().domes().stream().flatMap(dome -> dome.image().stream()))
                        .map(environment -> environment.map().width() + "x" + environment.map().height());
        return Stream.concat(textures, environments).collect(Collectors.joining(" "));
    }

    /**
     * Returns the hash of the files that a scene names.
     *
     * @param folder folder of the scene file
     * @param before time before which the files must have changed last, since they were read after it
     * @return empty if a file is newer
     * @throws IOException if one cannot be read
     */
    static Optional<ContentHash> filesOf(Scene scene, Path folder, FileTime before) throws IOException {
        SortedMap<String, Path> files = ReferencedFiles.of(scene, folder);
        var all = new StringBuilder();
        for (Map.Entry<String, Path> file : files.entrySet()) {
            all.append(file.getKey()).append('\0').append(ContentHash.of(file.getValue()).hex()).append('\n');
        }
        for (Path file : files.values()) {
            if (lastChange(file).compareTo(before) >= 0) {
                return Optional.empty();
            }
        }
        return Optional.of(ContentHash.of(all.toString().getBytes(StandardCharsets.UTF_8)));
    }

    /** Returns when a file's content or its place changed last, as far as the system knows. */
    private static FileTime lastChange(Path file) throws IOException {
        FileTime content = Files.getLastModifiedTime(file);
        try {
            FileTime place = (FileTime) Files.getAttribute(file, "unix:ctime");
            return place.compareTo(content) > 0 ? place : content;
        } catch (UnsupportedOperationException | IllegalArgumentException e) {
            return content;
        }
    }

    /** Returns the name of the picture's file. */
    String fileName() {
        return prefix(text) + files.hex().substring(0, 32) + KeptPictures.EXTENSION;
    }

    /** Returns what the names of the files of all pictures with a text start with. */
    static String prefix(ContentHash text) {
        return text.hex().substring(0, 32) + '-';
    }
}
