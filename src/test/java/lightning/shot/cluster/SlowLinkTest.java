package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.file.ContentHash;
import lightning.base.work.Await;
import lightning.base.work.DedicatedThread;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.Slow;
import lightning.shot.LocalFrameHost;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.Message;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Nodes at links that carry less than a part while a request waits for it. */
final class SlowLinkTest {
    private static final UUID SESSION = new UUID(5, 6);

    @TempDir
    private Path folder;

    /** @param side pixels of a texture that does not compress, 3 bytes each */
    private ShotRevision textured(int side) throws Exception {
        var image = new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB);
        var random = new Random(1);
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                image.setRGB(x, y, random.nextInt());
            }
        }
        return TexturedShot.write(folder, image, 150, 100, 2);
    }

    /** The thread that receives from all nodes must not wait until one has received a file: it would count others as silent. */
    @Test
    @Timeout(value = Await.TIMEOUT_SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void receivingThread_doesNotSendParts() throws Exception {
        var assets = new AssetTransfer(folder);
        AssetTransfer.Transfer transfer = assets.prepare(textured(8));
        var link = new CountDownLatch(1);
        List<Message> sent = Collections.synchronizedList(new ArrayList<>());
        BlockingQueue<Message> sentToOther = new LinkedBlockingQueue<>();
        var slow = new RemoteFrameHost(SESSION, "slow", assets, message -> {
            awaitUninterruptibly(link);
            sent.add(message);
        });
        var other = new RemoteFrameHost(new UUID(7, 8), "other", assets, sentToOther::add);
        var request = new Message.RequestContent(SESSION, transfer.hash(), 0);

        // A repeated request, because the answer is on its way.
        slow.handle(request);
        slow.handle(request);
        slow.handle(request);
        other.handle(new Message.RequestContent(new UUID(7, 8), transfer.hash(), 0));
        assertThat(sentToOther.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isInstanceOf(Message.ContentPart.class);
        link.countDown();
        slow.handle(new Message.RequestContent(SESSION, transfer.textHash(), 0));
        Await.until("the text is sent", () -> sent.stream().anyMatch(m -> ((Message.ContentPart) m).hash().equals(transfer.textHash())));
        assertThat(sent).hasSize(2);
        slow.disconnect();
        other.disconnect();
    }

    private static void awaitUninterruptibly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Nodes get parts of earlier revisions while large files of a new one are read. */
    @Test
    @Timeout(value = Await.TIMEOUT_SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void parts_areReadWhileFilesAreHashed() throws Exception {
        var hashing = new CountDownLatch(1);
        var done = new CountDownLatch(1);
        var assets = new AssetTransfer(folder, file -> {
            hashing.countDown();
            awaitUninterruptibly(done);
            return ContentHash.of(file);
        });
        ShotRevision revision = textured(8);
        Files.writeString(folder.resolve("plain.jen"), "jen 1\nsphere ball { }\n");
        AssetTransfer.Transfer plain =
                assets.prepare(new ShotRevision(JenReader.read(folder.resolve("plain.jen")).scene(), revision.shot()));
        Thread preparing = DedicatedThread.create("preparing", () -> {
            try {
                assets.prepare(revision);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
        preparing.start();
        hashing.await();
        assertThat(assets.readPart(plain.textHash(), 0, Message.PART_BYTES)).isEqualTo(plain.text());
        done.countDown();
        preparing.join();
    }

    /** At 100 kB/s, a part of 1 MiB takes ten seconds, and a request is repeated after two. */
    @Test
    @Slow
    void slowLink_carriesEachPartOnce() throws Exception {
        ShotRevision revision = textured(300);
        var network = new LocalNetwork(1, 0);
        List<Message> requests = Collections.synchronizedList(new ArrayList<>());
        network.observe(bytes -> {
            Message message = LocalNetwork.decode(bytes);
            if (message instanceof Message.RequestContent || message instanceof Message.RequestTiles) {
                requests.add(message);
            }
        });
        LocalNetwork.Endpoint end = network.addEndpoint();
        end.limit(100_000);
        try (var node = new RenderNode(end, new RenderNode.Settings("r", 1, 1 << 30, folder.resolve("node"),
                () -> new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 1 << 28), _ -> {}));
                ShotRelighter shot = ShotRelighter.of(1, 2, ShotListener.NONE);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, _ -> {})) {
            node.start();
            machines.start();
            shot.setRevision(revision);
            Await.until("all frames are current", shot::isIdle);
            FilmAssert.assertSameBits(shot.film(2).orElseThrow(), new ReferenceTracer(revision.sceneAt(2)).trace(), "slow-link");
        }
        Await.untilThreadEnded("lightning-node");
        Await.untilThreadEnded("lightning-films");
        assertThat(requests).doesNotHaveDuplicates().hasSizeGreaterThan(10);
    }
}
