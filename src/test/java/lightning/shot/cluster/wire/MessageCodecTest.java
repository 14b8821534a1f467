package lightning.shot.cluster.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.UUID;
import lightning.base.file.ContentHash;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

final class MessageCodecTest {
    private static final UUID SESSION = new UUID(1, 2);
    private static final ContentHash HASH = ContentHash.of(new byte[] {7});

    @Property
    void everyMessage_roundTrips(@ForAll("messages") Message message) throws WireException {
        byte[] bytes = MessageCodec.encode(message);
        // Records compare arrays by identity, so their bytes are compared.
        assertThat(MessageCodec.encode(MessageCodec.decode(bytes))).isEqualTo(bytes);
        assertThat(MessageCodec.decode(bytes).getClass()).isEqualTo(message.getClass());
    }

    @Property
    void truncatedMessage_isRejected(@ForAll("messages") Message message, @ForAll double part) {
        byte[] bytes = MessageCodec.encode(message);
        int length = (int) (Math.abs(part) % 1 * bytes.length);
        assertThatThrownBy(() -> MessageCodec.decode(Arrays.copyOf(bytes, length))).isInstanceOf(WireException.class)
                .hasMessageContaining("expected").hasMessageContaining("found");
    }

    @Property
    void messageWithTrailingBytes_isRejected(@ForAll("messages") Message message) {
        byte[] bytes = MessageCodec.encode(message);
        assertThatThrownBy(() -> MessageCodec.decode(Arrays.copyOf(bytes, bytes.length + 1))).isInstanceOf(WireException.class)
                .hasMessageContaining("expected the end of the message");
    }

    @Property
    void anyBytes_areDecodedOrRejected(@ForAll byte[] bytes, @ForAll("messages") Message message) {
        byte[] damaged = MessageCodec.encode(message);
        for (int i = 0; i < Math.min(bytes.length, 3); i++) {
            damaged[Math.floorMod(bytes[i] * 31 + i, damaged.length)] = bytes[i];
        }
        for (byte[] each : new byte[][] {bytes, damaged}) {
            try {
                MessageCodec.decode(each);
            } catch (WireException e) {
                assertThat(e.getMessage()).contains("expected");
            }
        }
    }

    @Test
    void otherVersion_isReported() {
        byte[] bytes = MessageCodec.encode(new Message.CloseSession(SESSION));
        bytes[2] = 9;
        assertThatThrownBy(() -> MessageCodec.decode(bytes)).isInstanceOf(WireException.class)
                .hasMessage("at byte 2: expected protocol version 1, found 9; all machines must run the same release");
    }

    @Test
    void excessiveLength_allocatesNothing() {
        byte[] bytes = MessageCodec.encode(new Message.ContentPart(SESSION, HASH, 0, new byte[4]));
        int length = bytes.length - 8;
        // Nearly a mebibyte with only four bytes present; then two gibibytes.
        bytes[length + 1] = 0x0f;
        bytes[length + 2] = (byte) 0xff;
        bytes[length + 3] = 0;
        assertThatThrownBy(() -> MessageCodec.decode(bytes)).isInstanceOf(WireException.class)
                .hasMessageContaining("expected the part (1048320 bytes), found 4 bytes");
        bytes[length] = 0x7f;
        assertThatThrownBy(() -> MessageCodec.decode(bytes)).isInstanceOf(WireException.class).hasMessageContaining("0 to 1048576");
    }

    @Test
    void tooLargeMessage_isRejected() {
        assertThatThrownBy(() -> MessageCodec.decode(new byte[Message.MAX_BYTES + 1])).isInstanceOf(WireException.class)
                .hasMessage("expected at most 2097152 bytes, found 2097153");
    }

    @Provide
    Arbitrary<Message> messages() {
        Arbitrary<UUID> session = Combinators.combine(Arbitraries.longs(), Arbitraries.longs()).as(UUID::new);
        Arbitrary<Integer> number = Arbitraries.integers().between(0, 1 << 20);
        Arbitrary<Long> large = Arbitraries.longs().greaterOrEqual(0);
        Arbitrary<String> text = Arbitraries.strings().ascii().ofMaxLength(40);
        Arbitrary<byte[]> bytes = Arbitraries.bytes().array(byte[].class).ofMaxSize(200);
        Arbitrary<ContentHash> hash = bytes.map(ContentHash::of);
        return Arbitraries.oneOf(
                Combinators.combine(session, text).as(Message.OpenSession::new),
                Combinators.combine(session, text, number, large).as(Message.SessionOpened::new),
                Combinators.combine(session, large, number, hash, number).as(Message.UpdateFrame::new),
                Combinators.combine(session, large, text, number)
                        .as((s, l, t, n) -> new Message.FrameUpdated(s, l, n % 2 == 0, t, l, l, n, n, l, l)),
                Combinators.combine(session, large, Arbitraries.of(Message.FailureReason.class), text).as(Message.UpdateFailed::new),
                Combinators.combine(session, large).as(Message.CancelUpdate::new),
                Combinators.combine(session, hash, large).as(Message.RequestContent::new),
                Combinators.combine(session, hash, large, bytes).as(Message.ContentPart::new),
                Combinators.combine(session, large, number, number, number, number, number).as(Message.RequestTiles::new),
                Combinators.combine(session, large, number, number, number, number, bytes).as(Message.FilmTileData::new),
                Combinators.combine(session, large, number).as(Message.FilmUnavailable::new),
                Combinators.combine(session, number).as(Message.FocusFrame::new),
                Combinators.combine(session, number).as(Message.DropFrame::new),
                session.map(Message.Heartbeat::new),
                session.map(Message.CloseSession::new));
    }
}
