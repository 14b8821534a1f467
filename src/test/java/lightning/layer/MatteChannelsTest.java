package lightning.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrReader;
import lightning.render.RenderOptions;
import lightning.render.cache.FineSamples;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.sample.TryFolder;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import lightning.scene.node.Shape;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import tools.jackson.core.type.TypeReference;
import tools.jackson.databind.json.JsonMapper;

/** Mattes of a written file equal a count of the picture's samples without BVH, for every object, material and asset. */
@Slow
class MatteChannelsTest {
    private static final List<String> LAYERS = List.of("CryptoObject", "CryptoMaterial", "CryptoAsset");

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void coverages_areThoseOfTheSamples(@ForAll("sessions") EditSession session, @ForAll AntialiasMode mode,
            @ForAll @IntRange(min = 2, max = 5) int grid) throws IOException {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(2))) {
            for (Scene scene : session.timedScenes()) {
                renderer.render(scene.withPicture(scene.picture().withSampling(new SamplingSettings(mode, grid))), Progress.NONE);
            }
            Mattes mattes = new Mattes(renderer, 64);
            List<List<String>> hits = sampleHits(renderer.cache(), Shape::name);
            assertCoverages(mattes, "CryptoObject", hits);
            assertCoverages(mattes, "CryptoMaterial", sampleHits(renderer.cache(), Shape::material));
            assertCoverages(mattes, "CryptoAsset", sampleHits(renderer.cache(), shape -> {
                var groups = renderer.scene().stage().enclosingGroups(shape.name());
                return groups.isEmpty() ? shape.name() : groups.getFirst().name();
            }));
            for (String layer : LAYERS) {
                for (int i = 0; i < hits.size(); i++) {
                    double sum = 0;
                    for (float coverage : mattes.coverages(layer, i).values()) {
                        sum += coverage;
                    }
                    double hit = hits.get(i).stream().filter(name -> !name.isEmpty()).count() / (double) hits.get(i).size();
                    // Each coverage of at most 1 is rounded by 2⁻²⁵ at most.
                    assertThat(sum).isCloseTo(hit, within(mattes.coverages(layer, i).size() * 0x1p-25));
                }
            }
        }
    }

    private static void assertCoverages(Mattes mattes, String layer, List<List<String>> hits) {
        for (int i = 0; i < hits.size(); i++) {
            Map<String, Integer> counts = new HashMap<>();
            hits.get(i).stream().filter(name -> !name.isEmpty()).forEach(name -> counts.merge(name, 1, Integer::sum));
            Map<String, Float> expected = new HashMap<>();
            int samples = hits.get(i).size();
            counts.forEach((name, count) -> expected.put(name, (float) count / samples));
            assertThat(mattes.coverages(layer, i)).as("%s of pixel %d", layer, i).isEqualTo(expected);
        }
    }

    /** Returns for each pixel the names that its samples hit, empty for the background. */
    private static List<List<String>> sampleHits(PixelCache cache, Function<Shape, String> name) {
        Scene scene = cache.scene();
        Geometry geometry = Geometry.of(scene);
        PixelRays rays = new PixelRays(scene);
        List<List<String>> hits = new ArrayList<>();
        Film film = cache.film();
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                List<String> pixel = new ArrayList<>();
                List<FineSamples> stages = cache.fineCount() == 0 ? List.of() : cache.fineTile(film.tileOf(x, y)).stages();
                for (FineSamples samples : stages) {
                    if (samples.pixelSet().get(Film.pixelInTile(x, y))) {
                        for (int cell : samples.cells().cells()) {
                            pixel.add(name(geometry, BruteForce.nearest(geometry, rays.ray(x, y, cell, samples.cells().grid())), name));
                        }
                    }
                }
                if (pixel.isEmpty()) {
                    pixel.add(name(geometry, BruteForce.nearest(geometry, rays.ray(x, y)), name));
                }
                hits.add(pixel);
            }
        }
        return hits;
    }

    private static String name(Geometry geometry, int primitive, Function<Shape, String> name) {
        return primitive < 0 || geometry.isLightFace(primitive) ? "" : name.apply(geometry.shape(primitive));
    }

    @Test
    void crowdedPixels_keepTheLargestCoverages() throws IOException {
        Scene studio = StudioScene.of(LightType.POINT);
        Scene scene = studio.withPicture(studio.picture().withSize(2, 2).withSampling(new SamplingSettings(AntialiasMode.EVERY, 8)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            Mattes all = new Mattes(renderer, 6);
            Mattes some = new Mattes(renderer, 2);
            assertThat(all.crowdedPixels).isZero();
            assertThat(some.crowdedPixels).isEqualTo((int) range(4).filter(i -> all.coverages("CryptoObject", i).size() > 2).count());
            assertThat(some.crowdedPixels).isPositive();
            for (int i = 0; i < 4; i++) {
                List<Float> largest = all.coverages("CryptoObject", i).values().stream().limit(2).toList();
                assertThat(List.copyOf(some.coverages("CryptoObject", i).values())).isEqualTo(largest);
            }
        }
    }

    private static IntStream range(int end) {
        return IntStream.range(0, end);
    }

    /** Mattes read from a file. */
    private static final class Mattes {
        private final Map<String, Map<Integer, String>> names = new HashMap<>();
        private final Map<String, float[]> values = new LinkedHashMap<>();
        private final int levels;
        private final int crowdedPixels;

        Mattes(Renderer renderer, int levels) throws IOException {
            this.levels = levels;
            LayeredExrWriter writer =
                    new LayeredExrWriter(renderer.cache(), renderer.options().engines(), ExrContent.mattes(levels), ExrLayout.DEFAULT,
                            Optional.empty());
            try (TryFolder files = new TryFolder(); WorkerPool workers = new WorkerPool(2)) {
                Path file = files.file("mattes.exr");
                writer.write(file, Long.MAX_VALUE, workers, Progress.NONE);
                read(file);
            }
            crowdedPixels = writer.crowdedPixels();
        }

        private void read(Path file) throws IOException {
            try (ExrReader reader = new ExrReader(file)) {
                Map<String, String> texts = reader.header().texts();
                texts.forEach((key, layer) -> {
                    if (key.matches("cryptomatte/[0-9a-f]{7}/name")) {
                        String prefix = key.substring(0, key.length() - 4);
                        assertThat(texts).containsEntry(prefix + "hash", "MurmurHash3_32").containsEntry(prefix + "conversion",
                                "uint32_to_float32");
                        Map<Integer, String> ids = new HashMap<>();
                        new JsonMapper().readValue(texts.get(prefix + "manifest"), new TypeReference<Map<String, String>>() {})
                                .forEach((name, hex) -> ids.put(Integer.parseUnsignedInt(hex, 16), name));
                        names.put(layer, ids);
                    }
                });
                assertThat(names).containsOnlyKeys(LAYERS);
                int width = reader.header().width();
                List<String> channels = reader.header().channels().stream().map(ExrChannel::name).toList();
                channels.forEach(channel -> values.put(channel, new float[width * reader.header().height()]));
                List<float[]> columns = List.copyOf(values.values());
                reader.read(channels, (x, y, numbers) -> {
                    for (int c = 0; c < numbers.length; c++) {
                        columns.get(c)[y * width + x] = numbers[c];
                    }
                });
            }
        }

        /** Returns the coverages of a pixel by name, in the order of their ranks. */
        Map<String, Float> coverages(String layer, int pixel) {
            Map<String, Float> coverages = new LinkedHashMap<>();
            float last = Float.POSITIVE_INFINITY;
            for (int level = 0; level < levels; level++) {
                String prefix = layer + String.format(Locale.ROOT, "%02d", level / 2) + ".";
                float id = values.get(prefix + (level % 2 == 0 ? "R" : "B"))[pixel];
                float coverage = values.get(prefix + (level % 2 == 0 ? "G" : "A"))[pixel];
                assertThat(coverage).isLessThanOrEqualTo(last);
                last = coverage;
                if (coverage > 0) {
                    assertThat(coverages.put(names.get(layer).get(Float.floatToRawIntBits(id)), coverage)).isNull();
                } else {
                    assertThat(Float.floatToRawIntBits(id)).isZero();
                }
            }
            return coverages;
        }
    }
}
