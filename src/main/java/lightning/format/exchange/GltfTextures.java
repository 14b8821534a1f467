package lightning.format.exchange;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import lightning.base.file.UnusableFileException;
import lightning.base.math.Affine2;
import lightning.format.exchange.assembly.PlacedTexture;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exchange.assembly.TextureAtlas;
import lightning.format.gltf.GltfImage;
import lightning.format.gltf.GltfScene;
import lightning.format.jen.asset.TextureFile;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;

/** Images of a glTF file as textures of a scene. */
final class GltfTextures {
    private final SceneAssembler assembler;
    private final GltfScene file;
    private final String meshFile;
    /** Names of embedded images, by their index. */
    private final Map<Integer, String> stems = new HashMap<>();

    /** @param meshFile name of the glTF file next to the scene */
    GltfTextures(SceneAssembler assembler, GltfScene file, String meshFile) {
        this.assembler = assembler;
        this.file = file;
        this.meshFile = meshFile;
    }

    /**
     * Returns the alpha of an image as a gray texture; empty if it is 1 everywhere, or the image cannot be used.
     *
     * @param name   what the values are, part of the name of the new file
     * @param change changes each value
     */
    Optional<TextureMap> alpha(GltfImage image, String name, DoubleUnaryOperator change) throws IOException, MeshException {
        Optional<byte[]> source = image.isPresent() ? bytes(image.index()).filter(TextureFile::hasAlpha) : Optional.empty();
        if (source.isEmpty()) {
            return Optional.empty();
        }
        try {
            Texture alpha = TextureFile.decode("alpha", source.get(), TextureUsage.OPACITY);
            float[] values = alpha.values();
            for (int i = 0; i < values.length; i++) {
                values[i] = (float) change.applyAsDouble(values[i]);
            }
            var png = new TextureAtlas(1, 1, alpha.width(), alpha.height(), TextureUsage.DATA, true);
            png.draw(new Texture(alpha.width(), alpha.height(), values), 0, 0);
            Optional<String> reference = file.imageReference(image.index());
            String stem =
                    reference.isPresent() ? reference.get().replaceFirst("^.*/", "").replaceFirst("\\.[^.]*$", "") : stem(image.index());
            return assembler.images.embedded(stem + "-" + name, png.png(), TextureUsage.DATA).map(map -> placed(map, image));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    /** Returns an image as a texture; empty if there is none or it cannot be used. */
    Optional<TextureMap> map(GltfImage image, TextureUsage usage) throws IOException, MeshException {
        return image.isPresent() ? map(image.index(), usage).map(map -> placed(map, image)) : Optional.empty();
    }

    private TextureMap placed(TextureMap map, GltfImage image) {
        TextureMap texture = map.withWrap(image.wrap());
        if (image.map().equals(Affine2.IDENTITY)) {
            return texture;
        }
        Optional<TextureMap> placed = PlacedTexture.of(texture, image.map());
        assembler.notes.add("textures with another scale and rotation than others of their material, placed like them",
                placed.isEmpty() ? 1 : 0);
        return placed.orElse(texture);
    }

    private Optional<TextureMap> map(int image, TextureUsage usage) throws IOException, MeshException {
        Optional<String> reference = file.imageReference(image);
        return reference.isPresent() ? assembler.images.file(reference.get(), usage)
                : embeddedBytes(image).isEmpty() ? Optional.empty()
                : assembler.images.embedded(stem(image), embeddedBytes(image).get(), usage);
    }

    /** Returns the content of an image; empty if it is missing. */
    Optional<byte[]> bytes(int image) throws IOException, MeshException {
        Optional<String> reference = file.imageReference(image);
        return reference.isPresent() ? assembler.images.bytes(reference.get()) : embeddedBytes(image);
    }

    private Optional<byte[]> embeddedBytes(int image) throws IOException {
        try {
            return Optional.of(file.imageBytes(image));
        } catch (MeshException e) {
            assembler.notes.add("embedded textures that are damaged");
            return Optional.empty();
        }
    }

    /** Returns the name for the file of an embedded image, another one for each image. */
    private String stem(int image) throws MeshException {
        String known = stems.get(image);
        if (known != null) {
            return known;
        }
        String name = file.imageName(image);
        String base = meshFile.replaceFirst("\\.[^.]*$", "") + "-" + (name.isEmpty() ? "image" + image : name);
        String stem = base;
        for (int i = 2; stems.containsValue(stem); i++) {
            stem = base + " " + i;
        }
        stems.put(image, stem);
        return stem;
    }
}
