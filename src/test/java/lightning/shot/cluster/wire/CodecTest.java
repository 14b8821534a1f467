package lightning.shot.cluster.wire;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.UUID;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

final class CodecTest {
    private static final UUID SESSION = new UUID(1, 2);
    private static final Hash HASH = Hash.of(new byte[] {7});

    @Property
    void everyMessage_isReadAsItWasWritten(@ForAll("messages") Message message) throws WireException {
        byte[] bytes = Codec.encode(message);
        // Records compare arrays by identity, so their bytes are compared.
        assertThat(Codec.encode(Codec.decode(bytes))).isEqualTo(bytes);
        assertThat(Codec.decode(bytes).getClass()).isEqualTo(message.getClass());
    }

    @Property
    void messageThatIsCut_isRefused(@ForAll("messages") Message message, @ForAll double part) {
        byte[] bytes = Codec.encode(message);
        int length = (int) (Math.abs(part) % 1 * bytes.length);
        assertThatThrownBy(() -> Codec.decode(Arrays.copyOf(bytes, length))).isInstanceOf(WireException.class)
                .hasMessageContaining("expected").hasMessageContaining("found");
    }

    @Property
    void messageWithMoreBehind_isRefused(@ForAll("messages") Message message) {
        byte[] bytes = Codec.encode(message);
        assertThatThrownBy(() -> Codec.decode(Arrays.copyOf(bytes, bytes.length + 1))).isInstanceOf(WireException.class)
                .hasMessageContaining("expected the end of the message");
    }

    @Property
    void anyBytes_areAMessageOrRefusedWithASentence(@ForAll byte[] bytes, @ForAll("messages") Message message) {
        byte[] damaged = Codec.encode(message);
        for (int i = 0; i < Math.min(bytes.length, 3); i++) {
            damaged[Math.floorMod(bytes[i] * 31 + i, damaged.length)] = bytes[i];
        }
        for (byte[] each : new byte[][] {bytes, damaged}) {
            try {
                Codec.decode(each);
            } catch (WireException e) {
                assertThat(e.getMessage()).contains("expected");
            }
        }
    }

    @Test
    void otherVersion_isNamed() {
        byte[] bytes = Codec.encode(new Message.End(SESSION));
        bytes[2] = 9;
        assertThatThrownBy(() -> Codec.decode(bytes)).isInstanceOf(WireException.class)
                .hasMessage("at byte 2: expected version 1 of the protocol, found 9; all machines must run the same release");
    }

    @Test
    void lengthBeyondWhatIsThere_asksForNoMemory() {
        byte[] bytes = Codec.encode(new Message.Part(SESSION, HASH, 0, new byte[4]));
        int length = bytes.length - 8;
        // Nearly a mebibyte, of which four bytes are there; then two gibibytes.
        bytes[length + 1] = 0x0f;
        bytes[length + 2] = (byte) 0xff;
        bytes[length + 3] = 0;
        assertThatThrownBy(() -> Codec.decode(bytes)).isInstanceOf(WireException.class)
                .hasMessageContaining("expected the part (1048320 bytes), found 4 bytes");
        bytes[length] = 0x7f;
        assertThatThrownBy(() -> Codec.decode(bytes)).isInstanceOf(WireException.class).hasMessageContaining("0 to 1048576");
    }

    @Test
    void messageBeyondTheLimit_isRefused() {
        assertThatThrownBy(() -> Codec.decode(new byte[Message.MOST_BYTES + 1])).isInstanceOf(WireException.class)
                .hasMessage("expected at most 2097152 bytes, found 2097153");
    }

    @Provide
    Arbitrary<Message> messages() {
        Arbitrary<UUID> session = Combinators.combine(Arbitraries.longs(), Arbitraries.longs()).as(UUID::new);
        Arbitrary<Integer> number = Arbitraries.integers().between(0, 1 << 20);
        Arbitrary<Long> large = Arbitraries.longs().greaterOrEqual(0);
        Arbitrary<String> text = Arbitraries.strings().ascii().ofMaxLength(40);
        Arbitrary<byte[]> bytes = Arbitraries.bytes().array(byte[].class).ofMaxSize(200);
        Arbitrary<Hash> hash = bytes.map(Hash::of);
        return Arbitraries.oneOf(
                Combinators.combine(session, text).as(Message.Hello::new),
                Combinators.combine(session, text, number, large).as(Message.Ready::new),
                Combinators.combine(session, large, number, hash, number).as(Message.Bring::new),
                Combinators.combine(session, large, text, number)
                        .as((s, l, t, n) -> new Message.Brought(s, l, n % 2 == 0, t, l, l, n, n, l, l)),
                Combinators.combine(session, large, Arbitraries.of(Message.Reason.class), text).as(Message.Failed::new),
                Combinators.combine(session, large).as(Message.Cancel::new),
                Combinators.combine(session, hash, large).as(Message.Need::new),
                Combinators.combine(session, hash, large, bytes).as(Message.Part::new),
                Combinators.combine(session, large, number, number, number, number, number).as(Message.Ask::new),
                Combinators.combine(session, large, number, number, number, number, bytes).as(Message.Pixels::new),
                Combinators.combine(session, large, number).as(Message.Gone::new),
                Combinators.combine(session, number).as(Message.Focus::new),
                Combinators.combine(session, number).as(Message.Forget::new),
                session.map(Message.Alive::new),
                session.map(Message.End::new));
    }
}
