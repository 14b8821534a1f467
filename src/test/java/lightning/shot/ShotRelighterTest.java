package lightning.shot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.ShotArbitraries;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.scene.shot.TrackRetargeting;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Checks that every frame has the bits of its reference trace, after any edits and with any caches. */
class ShotRelighterTest {
    private static final int FRAMES = 3;

    private final Path folder;

    ShotRelighterTest() throws IOException {
        folder = Files.createDirectories(Path.of("target", "shelves"));
    }

    /** Session of edits, and keyframes over its first scene. */
    record Scenario(EditSession session, Shot shot) {
        /** Returns the revisions of the session: keyframes follow their scenes. */
        List<ShotRevision> revisions() {
            List<Scene> scenes = session.scenes();
            ShotRevision[] revisions = new ShotRevision[scenes.size()];
            revisions[0] = new ShotRevision(scenes.getFirst(), shot);
            for (int i = 1; i < revisions.length; i++) {
                revisions[i] = new ShotRevision(scenes.get(i),
                        new TrackRetargeting(scenes.get(i - 1), scenes.get(i)).retarget(revisions[i - 1].shot()));
            }
            return List.of(revisions);
        }
    }

    /** Records the last report for each frame. */
    private static final class FilmCollector implements ShotListener {
        final Map<Integer, Film> films = new ConcurrentHashMap<>();

        @Override
        public void frameUpdated(FrameUpdate update, FrameState state) {
            films.put(update.frame(), update.film());
        }
    }

    @Provide
    Arbitrary<Scenario> stories() {
        return EditSession.mixedSessions().flatMap(s -> ShotArbitraries.shots(s.scenes().getFirst()).map(shot -> new Scenario(s, shot)));
    }

    @Provide
    Arbitrary<Long> budgets() {
        return Arbitraries.of(0L, 100_000L, 1_000_000L, Long.MAX_VALUE);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void everyFrame_afterAllEdits_matchesReference(@ForAll("stories") Scenario scenario, @ForAll("budgets") long memory,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll @IntRange(min = 1, max = 15) int settles,
            @ForAll @IntRange(max = ShotArbitraries.LAST - FRAMES) int first, @ForAll("budgets") long disk) throws Exception {
        var collector = new FilmCollector();
        var host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(threads), memory, folder, disk);
        try (ShotRelighter shot = ShotRelighter.of(first, first + FRAMES - 1, host, collector)) {
            List<ShotRevision> revisions = scenario.revisions();
            for (int i = 0; i < revisions.size(); i++) {
                shot.setRevision(revisions.get(i));
                shot.focus(first + i % FRAMES);
                // Some edits arrive while earlier ones are still rendered.
                if (i == revisions.size() - 1 || (settles >> i % 4 & 1) == 1) {
                    shot.awaitIdle();
                    check(shot, revisions.get(i), collector);
                    assertThat(disk == Long.MAX_VALUE ? host.problem() : Optional.empty()).isEmpty();
                }
            }
        }
    }

    private static void check(ShotRelighter shot, ShotRevision revision, FilmCollector collector) {
        for (int frame : IntStream.rangeClosed(shot.first(), shot.last()).toArray()) {
            Scene expected;
            try {
                expected = revision.sceneAt(frame);
            } catch (IllegalArgumentException e) {
                assertThat(shot.state(frame)).isEqualTo(FrameState.FAILED);
                continue;
            }
            assertThat(shot.state(frame)).isEqualTo(FrameState.CURRENT);
            FilmAssert.assertSameBits(collector.films.get(frame), new ReferenceTracer(expected).trace(), "relit-shot");
            shot.film(frame).ifPresent(film -> assertThat(film.hasSameBits(collector.films.get(frame))).isTrue());
        }
    }
}
