package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javafx.scene.control.TextField;
import lightning.base.text.ReleaseInfo;
import lightning.base.work.Await;
import lightning.document.DeskScene;
import lightning.document.OpenDocument;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.TestEditors;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.RenderMachines;
import lightning.render.RenderOptions;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.shot.FrameState;
import lightning.shot.LocalFrameHost;
import lightning.shot.cluster.FreePort;
import lightning.shot.cluster.NodeConfig;
import lightning.shot.cluster.RenderNode;
import lightning.shot.cluster.SelfSignedCertificate;
import lightning.shot.cluster.TlsNetwork;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

/** Film strip on nodes of the same process, joined through the dialog and connected over TLS. */
class RemoteFramesTest extends EditorFixture {
    private static final String SHOT =
            "shot { frames 1 4  camera { from { 1 0 2 9  4 1 2 9 } }  light lamp { intensity { 1 0.5  4 2.5 } } }";

    /** Short timeouts: nodes start one after the other, so the first should not search for others for long. */
    private static final NodeConfig.Timing FAST_TIMING = new NodeConfig.Timing(500, 15_000, 4000, 1500);

    private final InetAddress loopback = InetAddress.getLoopbackAddress();
    private final List<RenderNode> nodes = new ArrayList<>();
    private Path certificate;

    @BeforeEach
    void openStrip() throws Exception {
        certificate = folder.resolve("shared.p12");
        SelfSignedCertificate.write(certificate);
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + SHOT);
        OpenDocument opened = OpenDocument.open(file);
        robot.interact(() -> model().open(opened));
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.FILM_STRIP));
    }

    /** Waits until the closed nodes are done, before their folder is deleted. */
    @AfterEach
    void endNodes() throws Exception {
        nodes.forEach(RenderNode::close);
        Await.untilThreadEnded("lightning-node");
    }

    private RenderNode node(int port, int join) throws Exception {
        var place = new NodeConfig(loopback, port, 1, List.of(new InetSocketAddress(loopback, join)), certificate, FAST_TIMING);
        Path own = folder.resolve("node-" + port);
        var node = new RenderNode(new TlsNetwork(place), new RenderNode.Settings(ReleaseInfo.machineText(), 1, 1 << 30, own,
                () -> new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 1 << 28), _ -> {}));
        nodes.add(node);
        node.start();
        return node;
    }

    private void type(String field, String text) {
        // A click would compute bounds on this thread while the window's thread lays them out.
        robot.interact(() -> {
            TextField input = robot.lookup("#" + field).query();
            input.clear();
            input.requestFocus();
        });
        robot.write(text);
    }

    private void join(String hosts, Path file) {
        click("strip-elsewhere");
        type("machines-hosts", hosts);
        type("machines-certificate", file.toString());
        click("machines-begin");
    }

    private void waitForStatus(String text) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(Await.TIMEOUT_SECONDS);
        while (!status().equals(text)) {
            assertThat(System.nanoTime()).as("waited until the strip says %s; it says %s", text, status()).isLessThan(end);
            WaitForAsyncUtils.sleep(20, TimeUnit.MILLISECONDS);
        }
    }

    private String status() {
        return text("strip-progress");
    }

    private FilmStrip strip() {
        return TestEditors.inWindowThread(() -> robot.lookup("#strip").<FilmStripPane>query().strip().orElseThrow());
    }

    /** Asserts that the nodes' films are bit-identical to the reference, and that the thumbnails match. */
    private void assertAllExact() throws Exception {
        for (int frame = 1; frame <= 4; frame++) {
            Scene scene = model().editor().document().content().sceneAt(frame);
            Film exact = new ReferenceTracer(scene).trace();
            assertThat(film(frame).hasSameBits(exact)).as("every bit of frame " + frame).isTrue();
            int number = frame;
            waitFor("the thumbnail is up to date", () -> strip().isUpToDate(number));
            Film small = strip().thumbnail(frame).orElseThrow().film();
            assertThat(small.hasSameBits(Downscale.fit(exact.width(), exact.height(), small.width(), small.height()).apply(exact)))
                    .isTrue();
        }
    }

    /** Returns a film. If the node that holds it is lost, waits until another has rendered it. */
    private Film film(int frame) throws Exception {
        var film = new CompletableFuture<Film>();
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(Await.TIMEOUT_SECONDS);
        while (!film.isDone()) {
            assertThat(System.nanoTime()).as("waited for the film of frame " + frame).isLessThan(end);
            if (strip().state(frame) == FrameState.CURRENT) {
                // Films are fetched in sequence, so the next frame must not wait for a repeated request that is no longer needed.
                strip().fetch(frame, () -> !film.isDone(), film::complete);
            }
            WaitForAsyncUtils.sleep(200, TimeUnit.MILLISECONDS);
        }
        return film.get();
    }

    @Test
    void remoteFrames_afterEdit_areExact() throws Exception {
        int port = FreePort.next();
        int other = FreePort.next();
        node(port, port);
        node(other, port);
        join("127.0.0.1:" + port + ", 127.0.0.1:" + other, certificate);
        waitForStatus("2 nodes, 4 of 4 frames");
        assertThat(robot.lookup("#machines").tryQuery()).isEmpty();
        assertAllExact();
        robot.interact(() -> {
            model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 2));
            assertThat(strip().isUpToDate(4)).isFalse();
        });
        waitForStatus("2 nodes, 4 of 4 frames");
        assertAllExact();
    }

    @Test
    void lostMachine_isReported_andItsFramesMoveToAnother() throws Exception {
        int port = FreePort.next();
        int other = FreePort.next();
        node(port, port);
        RenderNode going = node(other, port);
        join("127.0.0.1:" + port, certificate);
        waitForStatus("2 nodes, 4 of 4 frames");
        going.close();
        waitForStatus("1 node, 4 of 4 frames");
        assertAllExact();
        nodes.removeFirst().close();
        waitForStatus("all nodes lost; rendering resumes when a node connects, 0 of 4 frames");
    }

    @Test
    void localFramesAgain_releaseMachines() throws Exception {
        int port = FreePort.next();
        node(port, port);
        join("127.0.0.1:" + port, certificate);
        waitForStatus("1 node, 4 of 4 frames");
        click("strip-here");
        waitForStatus("");
        assertThat(strip().frames().machineCount()).isEmpty();
        assertThat(isShown("strip-here")).isFalse();
    }

    @Test
    void noMachine_isReported_andLateMachineGetsFrames() throws Exception {
        int port = FreePort.next();
        join("127.0.0.1:" + port, certificate);
        waitForStatus("no node responds at 127.0.0.1:" + port + ": it may not be running, or its certificate differs, 0 of 4 frames");
        node(port, port);
        waitForStatus("1 node, 4 of 4 frames");
        assertAllExact();
    }

    @Test
    void remoteFrame_isShownWhileTracedLocally() throws Exception {
        int port = FreePort.next();
        node(port, port);
        join("127.0.0.1:" + port, certificate);
        waitForStatus("1 node, 4 of 4 frames");
        var film = new CompletableFuture<Film>();
        Scene fourth = model().editor().document().content().sceneAt(4);
        robot.interact(() -> {
            model().editor().showFrame(4);
            Scene scene = model().editor().scene();
            var preview = new RemoteFramePreview(model().editor(), model().files().windowExecutor(), (fetched, shownScene) -> {
                assertThat(shownScene).isSameAs(scene);
                film.complete(fetched);
            });
            // Marks the scene as in progress, even if it is already rendered locally.
            preview.update(model().editor().editorStateProperty().get().withSceneInProgress(Optional.of(scene)), strip());
        });
        assertThat(film.get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS).hasSameBits(new ReferenceTracer(fourth).trace())).isTrue();
        waitForPicture();
        assertCanvasShows(new ReferenceTracer(fourth).trace());
    }

    @Test
    void invalidCertificate_showsError_andKeepsInput() throws Exception {
        Path none = Files.writeString(folder.resolve("none.p12"), "words");
        join("127.0.0.1:1", none);
        waitFor("the message is shown", () -> text("machines-status").contains("none.p12: expected a key and certificate"));
        assertThat(text("machines-status")).doesNotContain("Exception");
        type("machines-certificate", folder.resolve("gone.p12").toString());
        click("machines-begin");
        waitFor("the message is shown", () -> text("machines-status").contains("gone.p12"));
        assertThat(robot.lookup("#strip-1").tryQuery()).isEmpty();
        type("machines-hosts", "a b");
        click("machines-begin");
        assertThat(text("machines-status")).contains("expected a host and a port");
        var preferences = new Preferences(folder.resolve("p"), Runnable::run);
        var next = new RenderMachines();
        robot.interact(() -> model().renderMachines().save(preferences));
        next.restore(preferences);
        assertThat(next.hostsProperty().get()).isEqualTo("127.0.0.1:1");
        assertThat(next.certificateProperty().get()).endsWith("gone.p12");
    }
}
