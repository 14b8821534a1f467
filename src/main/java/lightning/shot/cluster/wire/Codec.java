package lightning.shot.cluster.wire;

import java.util.UUID;
import lightning.shot.cluster.wire.Message.Alive;
import lightning.shot.cluster.wire.Message.Ask;
import lightning.shot.cluster.wire.Message.Bring;
import lightning.shot.cluster.wire.Message.Brought;
import lightning.shot.cluster.wire.Message.Cancel;
import lightning.shot.cluster.wire.Message.End;
import lightning.shot.cluster.wire.Message.Failed;
import lightning.shot.cluster.wire.Message.Focus;
import lightning.shot.cluster.wire.Message.Forget;
import lightning.shot.cluster.wire.Message.Gone;
import lightning.shot.cluster.wire.Message.Hello;
import lightning.shot.cluster.wire.Message.Need;
import lightning.shot.cluster.wire.Message.Part;
import lightning.shot.cluster.wire.Message.Pixels;
import lightning.shot.cluster.wire.Message.Ready;
import lightning.shot.cluster.wire.Message.Reason;

/** Messages as bytes: two letters, the version, the kind, the session, and what the kind has. */
public final class Codec {
    /** Of the protocol: members of another one are told so, and do not go together. */
    public static final int VERSION = 1;
    private static final int MARK = 'L' << 8 | 'n';
    private static final int SIDE = 1 << 20;
    private static final int MOST = Integer.MAX_VALUE;

    private Codec() {}

    public static byte[] encode(Message message) {
        var to = new WireSink();
        to.octet(MARK >> 8).octet(MARK & 0xff).octet(VERSION).octet(kind(message)).id(message.session());
        switch (message) {
            case Hello m -> to.text(m.release(), Message.TEXT_BYTES);
            case Ready m -> to.text(m.release(), Message.TEXT_BYTES).number(m.threads()).large(m.memory());
            case Bring m -> to.large(m.call()).number(m.frame()).hash(m.bill()).number(m.billBytes());
            case Brought m -> to.large(m.call()).flag(m.traced()).text(m.plan(), Message.TEXT_BYTES).large(m.rays()).large(m.nanoseconds())
                    .number(m.width()).number(m.height()).large(m.memory()).large(m.disk());
            case Failed m -> to.large(m.call()).octet(m.reason().ordinal()).text(m.sentence(), Message.TEXT_BYTES);
            case Cancel m -> to.large(m.call());
            case Need m -> to.hash(m.hash()).large(m.offset());
            case Part m -> to.hash(m.hash()).large(m.offset()).bytes(m.bytes());
            case Ask m -> to.large(m.call()).number(m.frame()).number(m.mostWidth()).number(m.mostHeight()).number(m.firstTile())
                    .number(m.tiles());
            case Pixels m -> to.large(m.call()).number(m.frame()).number(m.mostWidth()).number(m.mostHeight()).number(m.firstTile())
                    .bytes(m.bytes());
            case Gone m -> to.large(m.call()).number(m.frame());
            case Focus m -> to.number(m.frame());
            case Forget m -> to.number(m.frame());
            case Alive _,End _ -> {
                // Nothing but its session.
            }
        }
        return to.toBytes();
    }

    private static int kind(Message message) {
        return switch (message) {
            case Hello _ -> 1;
            case Ready _ -> 2;
            case Bring _ -> 3;
            case Brought _ -> 4;
            case Failed _ -> 5;
            case Cancel _ -> 6;
            case Need _ -> 7;
            case Part _ -> 8;
            case Ask _ -> 9;
            case Pixels _ -> 10;
            case Gone _ -> 11;
            case Focus _ -> 12;
            case Forget _ -> 13;
            case End _ -> 14;
            case Alive _ -> 15;
        };
    }

    /** @throws WireException if the bytes are no message of this version, whole and nothing behind */
    public static Message decode(byte[] bytes) throws WireException {
        if (bytes.length > Message.MOST_BYTES) {
            throw new WireException("expected at most " + Message.MOST_BYTES + " bytes, found " + bytes.length);
        }
        var from = new WireSource(bytes);
        int mark = from.octet("the mark") << 8 | from.octet("the mark");
        if (mark != MARK) {
            throw WireSource.wrong(0, "the mark", String.valueOf(MARK), mark);
        }
        int version = from.octet("the version");
        if (version != VERSION) {
            throw new WireException("at byte 2: expected version " + VERSION + " of the protocol, found " + version
                    + "; all machines must run the same release");
        }
        int kind = from.octet("the kind");
        UUID session = from.id("the session");
        Message message = body(kind, session, from);
        from.end();
        return message;
    }

    private static Message body(int kind, UUID session, WireSource from) throws WireException {
        return switch (kind) {
            case 1 -> new Hello(session, from.text("the release", Message.TEXT_BYTES));
            case 2 -> new Ready(session, from.text("the release", Message.TEXT_BYTES), from.number("threads", MOST), from.large("memory"));
            case 3 -> new Bring(session, from.large("the call"), frame(from), from.hash("the bill"), from.number("the bill's bytes", MOST));
            case 4 -> new Brought(session, from.large("the call"), from.flag("traced"), from.text("the plan", Message.TEXT_BYTES),
                    from.large("rays"), from.large("nanoseconds"), from.number("the width", SIDE), from.number("the height", SIDE),
                    from.large("memory"), from.large("disk"));
            case 5 -> new Failed(session, from.large("the call"), reason(from), from.text("the sentence", Message.TEXT_BYTES));
            case 6 -> new Cancel(session, from.large("the call"));
            case 7 -> new Need(session, from.hash("the content"), from.large("the offset"));
            case 8 -> new Part(session, from.hash("the content"), from.large("the offset"), from.bytes("the part", Message.PART_BYTES));
            case 9 -> new Ask(session, from.large("the call"), frame(from), from.number("the most width", SIDE),
                    from.number("the most height", SIDE), from.number("the first tile", SIDE), from.number("tiles", SIDE));
            case 10 -> new Pixels(session, from.large("the call"), frame(from), from.number("the most width", SIDE),
                    from.number("the most height", SIDE), from.number("the first tile", SIDE),
                    from.bytes("the pixels", Message.PART_BYTES));
            case 11 -> new Gone(session, from.large("the call"), frame(from));
            case 12 -> new Focus(session, frame(from));
            case 13 -> new Forget(session, frame(from));
            case 14 -> new End(session);
            case 15 -> new Alive(session);
            default -> throw WireSource.wrong(3, "the kind", "1 to 15", kind);
        };
    }

    private static int frame(WireSource from) throws WireException {
        return from.number("the frame", MOST);
    }

    private static Reason reason(WireSource from) throws WireException {
        int reason = from.octet("the reason");
        if (reason >= Reason.values().length) {
            throw new WireException("expected a reason below " + Reason.values().length + ", found " + reason);
        }
        return Reason.values()[reason];
    }
}
