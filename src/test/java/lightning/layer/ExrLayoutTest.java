package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrCompression;
import lightning.format.exr.ExrReader;
import lightning.format.exr.ExrType;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.sample.PythonPrograms;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Files of several parts, cropped files, and those of other compressions: OpenEXR's library reads the same bits from them. */
class ExrLayoutTest {
    /**
     * Compares the channels of files with those of the first one, and prints each file's parts, compressions and data window. A crop is
     * compared with its place in the whole picture.
     */
    private static final String COMPARE = """
            import json, sys, OpenEXR
            whole, result = None, []
            for name in sys.argv[1:]:
                file = OpenEXR.File(name, separate_channels=True)
                channels = {n: c.pixels for part in file.parts for n, c in part.channels.items()}
                (left, top), (right, bottom) = file.parts[0].header["dataWindow"]
                whole = whole or channels
                different = [n for n in whole if n not in channels
                             or whole[n][top:bottom + 1, left:right + 1].tobytes() != channels[n].tobytes()]
                result.append({"parts": [part.header.get("name", "") for part in file.parts], "different": different,
                               "count": len(channels), "display": [int(v) for v in file.parts[-1].header["displayWindow"][1]],
                               "compressions": [str(part.header["compression"]).split(".")[-1] for part in file.parts],
                               "window": [int(left), int(top), int(right), int(bottom)]})
            print(json.dumps(result))
            """;

    @TempDir
    private Path folder;

    private static Scene scene() {
        Scene scene = StudioScene.withFourLights(75, 70);
        return scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 4)));
    }

    private Path write(String name, ExrType type, ExrLayout layout) throws IOException {
        Path file = folder.resolve(name);
        ExrValues.write(scene(), new ExrContent(type, ExrContent.Layers.LIT, false, 4), layout, Optional.empty(), file);
        return file;
    }

    private List<JsonNode> compare(Path... files) throws IOException {
        PythonPrograms.require("OpenEXR");
        List<String> arguments = new ArrayList<>(List.of("-c", COMPARE));
        List.of(files).forEach(file -> arguments.add(file.toString()));
        return List.copyOf(new JsonMapper().readTree(PythonPrograms.script(folder, arguments)).values());
    }

    private static List<String> texts(JsonNode node, String field) {
        return node.get(field).values().stream().map(JsonNode::asString).toList();
    }

    private static List<Integer> numbers(JsonNode node, String field) {
        return node.get(field).values().stream().map(JsonNode::asInt).toList();
    }

    @Test
    void losslessCompressions_keepEveryBit() throws IOException {
        Path zip = write("zip.exr", ExrType.FLOAT, ExrLayout.DEFAULT);
        for (ExrCompression compression : ExrCompression.writable()) {
            if (!compression.isDwa()) {
                Path file = write(compression.word() + ".exr", ExrType.FLOAT, new ExrLayout(compression, false, Optional.empty()));
                JsonNode read = compare(zip, file).getLast();
                assertThat(texts(read, "different")).isEmpty();
                assertThat(texts(read, "compressions").getFirst())
                        .startsWith(compression == ExrCompression.NONE ? "NO_" : compression.name());
            }
        }
    }

    /** Normals, positions, ids and mattes keep every bit; so does alpha. */
    @Test
    void dwaa_changesOnlyColors() throws IOException {
        Path zip = write("zip.exr", ExrType.HALF, ExrLayout.DEFAULT);
        Path one = write("dwaa.exr", ExrType.HALF, new ExrLayout(ExrCompression.DWAA, false, Optional.empty()));
        Path parts = write("parts.exr", ExrType.HALF, new ExrLayout(ExrCompression.DWAA, true, Optional.empty()));
        List<JsonNode> read = compare(zip, one, parts);
        for (JsonNode file : read.subList(1, 3)) {
            assertThat(texts(file, "different")).contains("R", "key_diffuse.G").allMatch(name -> name.matches("(.*\\.)?[RGB]"))
                    .noneMatch(name -> name.startsWith("Crypto"));
        }
        List<String> names = texts(read.getLast(), "parts");
        List<String> compressions = texts(read.getLast(), "compressions");
        assertThat(compressions.get(names.indexOf("key_diffuse"))).isEqualTo("DWAA_COMPRESSION");
        assertThat(compressions.get(names.indexOf("CryptoObject00"))).isEqualTo("ZIP_COMPRESSION");
    }

    @Test
    void parts_haveTheLayersOfTheFile() throws IOException {
        Path one = write("one.exr", ExrType.HALF, ExrLayout.DEFAULT);
        Path parts = write("parts.exr", ExrType.HALF, new ExrLayout(ExrCompression.ZIP, true, Optional.empty()));
        JsonNode read = compare(one, parts).getLast();
        assertThat(texts(read, "different")).isEmpty();
        assertThat(texts(read, "parts")).startsWith("rgba").doesNotHaveDuplicates().contains("depth", "N", "P", "uv", "shape", "albedo",
                "N_filtered", "background", "key_specular", "sun_reflections", "CryptoAsset01");
        try (var whole = new ExrReader(one); var first = new ExrReader(parts)) {
            assertThat(first.header().texts()).containsAllEntriesOf(whole.header().texts());
            first.read(List.of("R", "G", "B", "A"), (x, y, v) -> {});
        }
    }

    /** The crop begins and ends within tiles and chunks. */
    @Test
    void crop_equalsThatPartOfTheWholePicture() throws IOException {
        Path whole = write("whole.exr", ExrType.FLOAT, ExrLayout.DEFAULT);
        Optional<ImageCrop> crop = Optional.of(new ImageCrop(21, 13, 70, 68));
        Path one = write("one.exr", ExrType.FLOAT, new ExrLayout(ExrCompression.ZIP, false, crop));
        Path parts = write("parts.exr", ExrType.FLOAT, new ExrLayout(ExrCompression.RLE, true, crop));
        for (JsonNode read : compare(whole, one, parts).subList(1, 3)) {
            assertThat(texts(read, "different")).isEmpty();
            assertThat(numbers(read, "window")).containsExactly(21, 13, 69, 67);
            assertThat(numbers(read, "display")).containsExactly(74, 69);
        }
    }

    @Test
    void singlePixel_isACrop() throws IOException {
        Path whole = write("whole.exr", ExrType.HALF, ExrLayout.DEFAULT);
        Path pixel = write("pixel.exr", ExrType.HALF,
                new ExrLayout(ExrCompression.ZIP, false, Optional.of(new ImageCrop(74, 69, 75, 70))));
        assertThat(texts(compare(whole, pixel).getLast(), "different")).isEmpty();
    }

    /** The estimate compresses 32 lines: all of this picture, so that it is the size without header and table. */
    @Test
    void estimateOfSmallPicture_isTheSizeOfItsChunks() throws IOException {
        Scene scene = StudioScene.withFourLights(60, 32);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(scene, Progress.NONE);
            var writer = new LayeredExrWriter(renderer.cache(), renderer.options().engines(), ExrContent.mattes(2), ExrLayout.DEFAULT,
                    Optional.empty());
            WriteEstimate estimate = writer.estimate(Long.MAX_VALUE, workers, Progress.NONE);
            int crowded = writer.crowdedPixels();
            Path file = folder.resolve("a.exr");
            writer.write(file, Long.MAX_VALUE, workers, Progress.NONE);
            long header = Files.size(file) - estimate.fileBytes();
            // Two chunks with two numbers each, and the table of their places, after less than 8 kB of attributes.
            assertThat(header).isBetween(2 * 8L + 2 * 8L, 8192L);
            assertThat(crowded).isZero();
            assertThat(estimate.memoryBytes()).isEqualTo(writer.bytesToWrite(1));
            assertThat(estimate.seconds()).isPositive();
        }
    }

    @Test
    void canceledEstimate_composesNothing() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(StudioScene.withFourLights(20, 16), Progress.NONE);
            var writer = new LayeredExrWriter(renderer.cache(), renderer.options().engines(), ExrType.HALF);
            assertThatThrownBy(() -> writer.estimate(Long.MAX_VALUE, workers, new Progress() {
                @Override
                public void report(int done, int total) {}

                @Override
                public boolean isCanceled() {
                    return true;
                }
            })).isInstanceOf(CancellationException.class);
        }
    }
}
