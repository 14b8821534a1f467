package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;
import lightning.base.work.Wait;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.shot.FrameState;
import lightning.shot.LocalKeeper;
import lightning.shot.RelitShot;
import lightning.shot.ShotListener;
import lightning.shot.Take;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Nodes and a coordinator in one process; what is between them loses messages, and is cut. */
@Slow
final class ClusterTest {
    private static final int LAST = 6;

    @TempDir
    private Path folder;

    private final List<AutoCloseable> open = new ArrayList<>();

    private FrameNode node(LocalNetwork.End end, String release) throws Exception {
        return node(end, release, 1 << 28);
    }

    /** @param room bytes that its frames may take */
    private FrameNode node(LocalNetwork.End end, String release, long room) throws Exception {
        Path own = folder.resolve("node" + open.size());
        var node = new FrameNode(end, new FrameNode.Settings(release, 1, 1 << 30, own,
                () -> LocalKeeper.firm(Options.DEFAULT.withThreads(1), room, own, 0), _ -> {}));
        node.start();
        open.add(node);
        return node;
    }

    private static Take edited(Take take, String assignment) {
        Scene scene = PropertyEdit.apply(take.scene(), assignment);
        return new Take(scene, take.shot());
    }

    private static void awaitAll(RelitShot shot) throws Exception {
        Wait.until("all frames are current", shot::isIdle);
    }

    /** A node may be lost after all frames were current, and while a film is on its way: then another traces it. */
    private static void checkAll(RelitShot shot, Take take) throws Exception {
        for (int frame = 1; frame <= LAST; frame++) {
            Film film = null;
            while (film == null) {
                awaitAll(shot);
                assertThat(shot.state(frame)).isIn(FrameState.CURRENT, FrameState.MISSING);
                film = shot.film(frame).orElse(null);
            }
            FilmAssert.assertSameBits(film, new ReferenceTracer(take.at(frame)).trace(), "cluster-" + frame);
        }
    }

    /** What a node still does after it is closed ends before its folder goes. */
    @AfterEach
    void closeNodes() throws Exception {
        for (AutoCloseable each : open) {
            each.close();
        }
        Wait.untilEnded("lightning-node");
        Wait.untilEnded("lightning-films");
    }

    @Test
    void frames_areTracedAndRelitByNodes_withTheirTextures() throws Exception {
        Take take = textured();
        var network = new LocalNetwork(1, 0);
        node(network.end(), "r");
        node(network.end(), "r");
        try (RelitShot shot = RelitShot.of(1, LAST, ShotListener.NONE);
                Machines machines = new Machines(network.end(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.edit(take);
            checkAll(shot, take);
            Take edited = edited(take, "lamp.intensity=0.3");
            shot.edit(edited);
            checkAll(shot, edited);
            assertThat(shot.bytes().memory()).isPositive();
        }
    }

    @Test
    void smallFilm_isTheMeanOfTheWholeOne() throws Exception {
        Take take = textured();
        var network = new LocalNetwork(1, 0);
        node(network.end(), "r");
        try (RelitShot shot = RelitShot.of(1, LAST, ShotListener.NONE);
                Machines machines = new Machines(network.end(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.edit(take);
            awaitAll(shot);
            Film whole = new ReferenceTracer(take.at(3)).trace();
            FilmAssert.assertSameBits(shot.film(3, 20, 9).orElseThrow(), new Downscale(12, 9).of(whole), "small-3");
            FilmAssert.assertSameBits(shot.film(3, 50, 30).orElseThrow(), whole, "whole-3");
        }
    }

    private Take textured() throws Exception {
        Files.createDirectories(folder.resolve("textures"));
        var image = new java.awt.image.BufferedImage(4, 4, java.awt.image.BufferedImage.TYPE_INT_RGB);
        image.setRGB(1, 2, 0xff8040);
        javax.imageio.ImageIO.write(image, "png", folder.resolve("textures/spots.png").toFile());
        Files.writeString(folder.resolve("textured.jen"), """
                jen 1
                picture { size 40 30 }
                camera { from 0 1 6 to 0 0 0 }
                material spotted { texture "spots.png" }
                sphere ball { material spotted }
                light lamp point { at 2 4 5 intensity 1 }
                shot { frames 1 6 camera { from { 1 0 1 6 6 2 1 5 } } }
                """);
        JenDocument document = JenReader.read(folder.resolve("textured.jen"));
        return new Take(document.scene(), document.shot().orElseThrow());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void nodesThatAreCutAndComeBackWhileEditsGoOn_loseNoFrame(long seed) throws Exception {
        Take take = textured();
        var random = new Random(seed);
        var network = new LocalNetwork(seed, 0.01);
        List<LocalNetwork.End> ends = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            ends.add(network.end());
            node(ends.getLast(), "r");
        }
        try (RelitShot shot = RelitShot.of(1, LAST, ShotListener.NONE);
                Machines machines = new Machines(network.end(), "r", folder, shot, _ -> {})) {
            machines.start();
            for (int edit = 0; edit < 12; edit++) {
                take = edited(take, "lamp.intensity=" + (1 + edit));
                shot.edit(take);
                shot.focus(1 + random.nextInt(LAST));
                Thread.sleep(random.nextInt(30));
                network.cut(ends.get(random.nextInt(3)), random.nextBoolean());
                if (random.nextInt(6) == 0) {
                    ends.add(network.end());
                    node(ends.getLast(), "r");
                }
            }
            for (LocalNetwork.End end : ends) {
                network.cut(end, false);
            }
            checkAll(shot, take);
        }
    }

    @Test
    void framesOfALostNode_areMissingUntilOthersTraceThem() throws Exception {
        Take take = textured();
        var network = new LocalNetwork(1, 0);
        LocalNetwork.End end = network.end();
        node(end, "r");
        List<String> gone = Collections.synchronizedList(new ArrayList<>());
        var listener = new ShotListener() {
            @Override
            public void gone(lightning.shot.KeeperGoneException problem) {
                gone.add(problem.getMessage());
            }
        };
        try (RelitShot shot = RelitShot.of(1, LAST, listener);
                Machines machines = new Machines(network.end(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.edit(take);
            awaitAll(shot);
            assertThat(machines.count()).isEqualTo(1);
            network.cut(end, true);
            Wait.until("it is told that the node is gone", () -> !gone.isEmpty());
            assertThat(gone).containsExactly("the node member 0 is there no more; others trace its frames again");
            assertThat(shot.state(1)).isEqualTo(FrameState.MISSING);
            assertThat(shot.film(1)).isEmpty();
            node(network.end(), "r");
            checkAll(shot, take);
        }
    }

    @Test
    void nodeThatAloneSawTheCoordinatorLeave_isTakenAnew() throws Exception {
        Take take = textured();
        var network = new LocalNetwork(1, 0);
        FrameNode node = node(network.end(), "r");
        LocalNetwork.End asking = network.end();
        try (RelitShot shot = RelitShot.of(1, LAST, ShotListener.NONE);
                Machines machines = new Machines(asking, "r", folder, shot, _ -> {})) {
            machines.start();
            shot.edit(take);
            awaitAll(shot);
            node.changed(Set.of());
            checkAll(shot, take);
        }
    }

    @Test
    void nodeOfAnotherRelease_isLeftAsideWithASentence() throws Exception {
        var network = new LocalNetwork(1, 0);
        node(network.end(), "other");
        List<String> said = Collections.synchronizedList(new ArrayList<>());
        try (RelitShot shot = RelitShot.of(1, LAST, ShotListener.NONE);
                Machines machines = new Machines(network.end(), "r", folder, shot, said::add)) {
            machines.start();
            Wait.until("it is told why the node is left aside", () -> !said.isEmpty());
            assertThat(said).containsExactly("member 0 is left aside: it runs other, this machine r");
            assertThat(machines.count()).isZero();
        }
    }

    @Test
    void framesThatANodeHasNoRoomFor_areTracedByAnother_andFailWithASentenceWhereThereIsNone() throws Exception {
        Take take = textured();
        long each;
        try (LocalKeeper keeper = new LocalKeeper(Options.DEFAULT.withThreads(1), 1 << 28)) {
            keeper.bring(1, take, Progress.NONE);
            each = keeper.bytes().memory();
        }
        var joined = new AtomicInteger();
        List<String> failed = Collections.synchronizedList(new ArrayList<>());
        var listener = new ShotListener() {
            @Override
            public void failed(int frame, Throwable problem) {
                failed.add(problem.getMessage());
            }

            @Override
            public void joined() {
                joined.incrementAndGet();
            }
        };
        var network = new LocalNetwork(1, 0);
        node(network.end(), "r", 5 * each / 2);
        try (RelitShot shot = RelitShot.of(1, LAST, listener);
                Machines machines = new Machines(network.end(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.edit(take);
            awaitAll(shot);
            assertThat(failed).hasSize(LAST - 2).allSatisfy(sentence -> assertThat(sentence)
                    .matches("nobody has room for it: the node member 0: the frame takes about .* MB, and there is room for .* MB more"));
            node(network.end(), "r", LAST * each);
            Wait.until("the node is asked too", () -> joined.get() == 2);
            checkAll(shot, take);
            Take edited = edited(take, "lamp.at=2 4 3");
            shot.edit(edited);
            checkAll(shot, edited);
            assertThat(failed).hasSize(LAST - 2);
        }
    }
}
