package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.WeakHashMap;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrType;
import lightning.format.jen.PropertyEdit;
import lightning.layer.ExrValues;
import lightning.layer.LayeredExrWriter;
import lightning.render.RenderOptions;
import lightning.render.cache.PictureFile;
import lightning.render.cache.PixelCache;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.image.ViewTransform;
import lightning.render.match.LightMatch;
import lightning.render.match.MatchChange;
import lightning.render.match.MatchResult;
import lightning.render.match.MatchSettings;
import lightning.render.match.ReferenceImage;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.review.ReviewContent;
import lightning.review.ReviewLook;
import lightning.review.ReviewPage;
import lightning.review.ReviewPicture;
import lightning.sample.FeatureScene;
import lightning.sample.Nightly;
import lightning.sample.Slow;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Edits and other steps of a session on scenes that have each two features together, at night each three. */
@Slow
class FeatureCombinationsTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final List<FeatureScene> PAIRS = FeatureScene.covering(2);

    /** Pictures before the edits, and after that of a light. */
    private static final Map<FeatureScene, PixelCache> START = new WeakHashMap<>();
    private static final Map<FeatureScene, Film> EDITED = new WeakHashMap<>();

    @TempDir
    private Path folder;

    /** Returns the scenes of the usual check, and lists them in a file for people. */
    static List<FeatureScene> pairs() throws IOException {
        Files.write(Path.of("target/feature-pairs.txt"), PAIRS.stream().map(FeatureScene::toString).toList());
        return PAIRS;
    }

    static List<FeatureScene> triples() {
        return FeatureScene.covering(3);
    }

    /** Pictures are slow to trace without a cache: compares the first edit with a full trace, and all edits with the reference. */
    @ParameterizedTest
    @MethodSource("pairs")
    void edits_equalTheReference(FeatureScene scene) {
        try (Renderer renderer = rendered(scene)) {
            render(renderer, scene.scenes().get(1), EDITED.get(scene));
            renderer.render(scene.scenes().get(2), Progress.NONE);
            render(renderer, scene.scenes().get(3), new ReferenceTracer(scene.scenes().get(3)).trace());
        }
    }

    private static void render(Renderer renderer, Scene scene, Film expected) {
        UpdateResult update = renderer.render(scene, Progress.NONE);
        FilmAssert.assertSameBits(renderer.film(), expected, "features");
        assertThat(AccuracyGuarantee.of(renderer, update).text()).isEqualTo("exact");
    }

    private static Film fullTrace(Scene scene) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene, Geometry.of(scene)).trace(workers, Progress.NONE).film();
        }
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void match_isNoWorseThanBefore(FeatureScene scene) {
        try (Renderer renderer = rendered(scene)) {
            assertThat(match(renderer, START.get(scene).film(), Set.of()).errorBefore()).isLessThan(1e-5);
            assertMatches(renderer, scene, Set.of());
            assertMatches(renderer, scene, Set.of(MatchChange.COLORS));
            assertContinues(renderer, scene);
        }
    }

    private static void assertMatches(Renderer renderer, FeatureScene scene, Set<MatchChange> changes) {
        MatchResult result = match(renderer, EDITED.get(scene), changes);
        assertThat(result.errorAfter()).isLessThanOrEqualTo(result.errorBefore());
    }

    private static MatchResult match(Renderer renderer, Film reference, Set<MatchChange> changes) {
        MatchSettings settings =
                new MatchSettings(Optional.empty(), changes, MatchSettings.Reference.FIXED, MatchSettings.Reference.FIXED, 0);
        return LightMatch.of(renderer.cache(), OPTIONS, ReferenceImage.of(reference), settings, Progress.NONE);
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void layers_sumToTheImage(FeatureScene scene) throws IOException {
        try (Renderer renderer = rendered(scene); WorkerPool workers = new WorkerPool(1)) {
            Path file = folder.resolve("layers.exr");
            new LayeredExrWriter(renderer.cache(), OPTIONS.engines(), ExrType.FLOAT).write(file, Long.MAX_VALUE, workers, Progress.NONE);
            ExrValues values = new ExrValues(file);
            for (String color : List.of("R", "G", "B")) {
                float[] beauty = values.channel(color);
                float[] sum = new float[beauty.length];
                for (String layer : values.list("lightning/sum")) {
                    float[] part = values.channel(layer + "." + color);
                    for (int i = 0; i < sum.length; i++) {
                        sum[i] += part[i];
                    }
                }
                assertThat(sum).isEqualTo(beauty);
            }
            assertContinues(renderer, scene);
        }
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void shares_arePartsOfThePicture(FeatureScene scene) {
        try (Renderer renderer = rendered(scene)) {
            LightShares shares = LightShares.of(renderer.cache(), OPTIONS, Progress.NONE);
            List<Double> all = Contribution.sources(scene.scenes().getFirst()).stream().map(shares::of).toList();
            assertThat(all).allMatch(share -> share >= 0 && share <= 1);
            LightContributions found = LightContributions.of(renderer.cache(), OPTIONS, ViewTransform.DEFAULT,
                    LightContributions.Region.ofFilm(renderer.film()), Progress.NONE);
            assertThat(found.lights().stream().map(LightContribution::imageShare)).isEqualTo(all);
            assertContinues(renderer, scene);
        }
    }

    /** One look differs in what faders of the page show, one has a picture of its own. */
    @ParameterizedTest
    @MethodSource("pairs")
    void reviewPage_hasEveryLightAndLook(FeatureScene scene) throws IOException {
        try (Renderer renderer = rendered(scene)) {
            Scene sent = scene.scenes().getFirst();
            Light key = sent.light("key").orElseThrow();
            ReviewContent content = ReviewContent.of("features", new ReviewPicture(OptionalInt.empty(), sent,
                    List.of(new ReviewLook("dim", sent.withLight(key.withIntensity(0.1))),
                            new ReviewLook("moved", sent.withLight(key.withPosition(Vec3.Y))))),
                    SceneView.of(sent));
            Path page = folder.resolve("page.html");
            ReviewPage.write(page, content, renderer, OPTIONS, Progress.NONE);
            assertThat(Files.readString(page).split("id=\"layer-", -1)).hasSize(1 + content.lights().size() + 1 + 1);
            renderer.render(sent, Progress.NONE);
            assertContinues(renderer, scene);
        }
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void keptPicture_continuesWithoutARay(FeatureScene scene) throws IOException {
        try (Renderer renderer = rendered(scene); Renderer other = new Renderer(OPTIONS)) {
            Scene kept = scene.scenes().getFirst();
            assertThat(PictureFile.canWrite(renderer.cache())).isTrue();
            Path file = folder.resolve("kept.picture");
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
                PictureFile.write(renderer.cache(), channel);
            }
            PixelCache read = PictureFile.read(file, other.prepare(kept), kept);
            other.restore(read);
            assertThat(other.render(kept, Progress.NONE).rays().total()).isZero();
            assertContinues(other, scene);
        }
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void assignment_equalsTheEdit(FeatureScene scene) {
        Scene edited = scene.scenes().getFirst();
        for (int step = 1; step < scene.scenes().size(); step++) {
            edited = PropertyEdit.apply(edited, scene.assignments().get(step - 1));
            assertThat(edited).isEqualTo(scene.scenes().get(step));
        }
    }

    /** The usual check has the pairs in the tests above. */
    @ParameterizedTest
    @MethodSource("triples")
    @Nightly
    void everyStep_onTriples(FeatureScene scene) throws IOException {
        edits_equalTheReference(scene);
        match_isNoWorseThanBefore(scene);
        try (Renderer renderer = rendered(scene)) {
            for (Scene edited : scene.scenes()) {
                render(renderer, edited, new ReferenceTracer(edited).trace());
            }
            renderer.render(scene.scenes().getFirst(), Progress.NONE);
            for (MatchChange change : MatchChange.values()) {
                assertMatches(renderer, scene, Set.of(change));
            }
            assertContinues(renderer, scene);
        }
        layers_sumToTheImage(scene);
        shares_arePartsOfThePicture(scene);
        reviewPage_hasEveryLightAndLook(scene);
        keptPicture_continuesWithoutARay(scene);
        assignment_equalsTheEdit(scene);
    }

    /** Returns a renderer with the picture before the edits, which is rendered once. */
    private static Renderer rendered(FeatureScene scene) {
        Renderer renderer = new Renderer(OPTIONS);
        PixelCache start = START.computeIfAbsent(scene, first -> {
            renderer.render(first.scenes().getFirst(), Progress.NONE);
            return renderer.cache();
        });
        EDITED.computeIfAbsent(scene, edited -> fullTrace(edited.scenes().get(1)));
        renderer.restore(start);
        return renderer;
    }

    /** Asserts that a step left the picture as it was, and that the next edit of a light is exact. */
    private static void assertContinues(Renderer renderer, FeatureScene scene) {
        FilmAssert.assertSameBits(renderer.film(), START.get(scene).film(), "features");
        renderer.render(scene.scenes().get(1), Progress.NONE);
        FilmAssert.assertSameBits(renderer.film(), EDITED.get(scene), "features");
    }
}
