package lightning.layer;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrReader;
import lightning.format.exr.ExrType;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.sample.TryFolder;
import lightning.scene.Scene;
import tools.jackson.core.type.TypeReference;
import tools.jackson.databind.json.JsonMapper;

/** Channels and texts of a file. */
public final class ExrValues {
    final Map<String, float[]> values = new LinkedHashMap<>();
    private final Map<String, String> attributes;
    final int width;
    final int height;

    public ExrValues(Path file) throws IOException {
        try (ExrReader reader = new ExrReader(file)) {
            width = reader.header().width();
            height = reader.header().height();
            attributes = new HashMap<>(reader.header().texts());
            List<String> names = reader.header().channels().stream().map(ExrChannel::name).toList();
            names.forEach(name -> values.put(name, new float[width * height]));
            List<float[]> columns = new ArrayList<>(values.values());
            reader.read(names, (x, y, numbers) -> {
                for (int c = 0; c < numbers.length; c++) {
                    columns.get(c)[y * width + x] = numbers[c];
                }
            });
        }
    }

    public float[] channel(String name) {
        return values.get(name);
    }

    public List<String> list(String attribute) {
        return new JsonMapper().readValue(attributes.get(attribute), new TypeReference<List<String>>() {});
    }

    Map<String, String> map(String attribute) {
        return new JsonMapper().readValue(attributes.get(attribute), new TypeReference<Map<String, String>>() {});
    }

    /** Returns the sum of some layers: red, green, blue of each pixel. */
    float[] sum(List<String> layers) {
        float[] rgb = new float[3 * width * height];
        for (String layer : layers) {
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] += channel(layer + "." + "RGB".charAt(i % 3))[i / 3];
            }
        }
        return rgb;
    }

    /** Renders a scene and writes its layers as 32-bit floats. */
    static void write(Scene scene, ExrLayout layout, Optional<ShotFrame> frame, Path file) throws IOException {
        write(scene, ExrContent.layers(ExrType.FLOAT), layout, frame, file);
    }

    /** Renders a scene and writes some content. */
    static void write(Scene scene, ExrContent content, ExrLayout layout, Optional<ShotFrame> frame, Path file) throws IOException {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(2)); WorkerPool workers = new WorkerPool(2)) {
            renderer.render(scene, Progress.NONE);
            new LayeredExrWriter(renderer.cache(), renderer.options().engines(), content, layout, frame).write(file, Long.MAX_VALUE,
                    workers,
                    Progress.NONE);
        }
    }

    /** Renders a scene and returns its layers as 32-bit floats. */
    static ExrValues of(Scene scene, Optional<ShotFrame> frame) throws IOException {
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("layers.exr");
            write(scene, ExrLayout.DEFAULT, frame, file);
            return new ExrValues(file);
        }
    }
}
