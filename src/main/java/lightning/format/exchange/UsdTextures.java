package lightning.format.exchange;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.file.RegularFile;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;
import lightning.scene.SceneLimits;
import lightning.scene.Texture;
import lightning.scene.TextureMap;

/** Image files of a stage, each copied once. */
final class UsdTextures {
    private static final int MAX_BYTES = 64 << 20;
    private static final int MAX_FILES = 256;
    private static final double MIN_REPEAT = 1e-6;

    private final SceneAssembler assembler;
    private final Map<Path, Optional<String>> names = new HashMap<>();

    UsdTextures(SceneAssembler assembler) {
        this.assembler = assembler;
    }

    /** Returns a texture; empty if absent, missing or of another format. */
    Optional<TextureMap> map(JsonValue image) throws IOException, MeshException {
        if (!image.isPresent()) {
            return Optional.empty();
        }
        Optional<Path> place = UsdStage.place(image);
        assembler.notes.add("textures that are missing", place.isEmpty() ? 1 : 0);
        if (place.isEmpty()) {
            return Optional.empty();
        }
        if (!names.containsKey(place.get())) {
            names.put(place.get(), name(image, place.get()));
        }
        double[] repeat = image.get("repeat").numbers(1, 1);
        return names.get(place.get()).map(file -> new TextureMap(file, repeat(repeat[0]), repeat(repeat[1]),
                new Texture(1, 1, new float[3])));
    }

    private static double repeat(double v) {
        double limited = Math.clamp(UsdNumbers.tidy(v), -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
        return Math.abs(limited) < MIN_REPEAT ? 1 : limited;
    }

    private Optional<String> name(JsonValue image, Path place) throws IOException, MeshException {
        Optional<byte[]> bytes = bytes(image);
        if (bytes.isEmpty() || !SceneAssembler.isPngOrJpeg(bytes.get())) {
            assembler.notes.add("textures that are not PNG or JPEG, or have more than 64 MiB");
            return Optional.empty();
        }
        if (names.values().stream().filter(Optional::isPresent).count() >= MAX_FILES) {
            assembler.notes.add("textures after the first " + MAX_FILES);
            return Optional.empty();
        }
        String name = image.get("name").text().orElse("texture");
        return Optional.of(assembler.addFile(place, name));
    }

    /** Returns the content of an image file; empty if it is missing or too large. */
    Optional<byte[]> bytes(JsonValue image) throws IOException, MeshException {
        Optional<Path> place = UsdStage.place(image);
        return place.isEmpty() || Files.size(place.get()) > MAX_BYTES ? Optional.empty()
                : Optional.of(RegularFile.readBytes(place.get(), "a PNG or JPEG file", MAX_BYTES));
    }
}
