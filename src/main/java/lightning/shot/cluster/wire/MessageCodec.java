package lightning.shot.cluster.wire;

import java.util.UUID;
import lightning.shot.cluster.wire.Message.CancelUpdate;
import lightning.shot.cluster.wire.Message.CloseSession;
import lightning.shot.cluster.wire.Message.ContentPart;
import lightning.shot.cluster.wire.Message.DropFrame;
import lightning.shot.cluster.wire.Message.FailureReason;
import lightning.shot.cluster.wire.Message.FilmTileData;
import lightning.shot.cluster.wire.Message.FilmUnavailable;
import lightning.shot.cluster.wire.Message.FocusFrame;
import lightning.shot.cluster.wire.Message.FrameUpdated;
import lightning.shot.cluster.wire.Message.Heartbeat;
import lightning.shot.cluster.wire.Message.OpenSession;
import lightning.shot.cluster.wire.Message.RequestContent;
import lightning.shot.cluster.wire.Message.RequestTiles;
import lightning.shot.cluster.wire.Message.SessionOpened;
import lightning.shot.cluster.wire.Message.UpdateFailed;
import lightning.shot.cluster.wire.Message.UpdateFrame;

/** Binary message format: two magic bytes, the version, the kind, the session, and the fields of the kind. */
public final class MessageCodec {
    /** Protocol version; members of another version are reported and ignored. */
    public static final int VERSION = 1;
    private static final int MAGIC = 'L' << 8 | 'n';
    private static final int MAX_SIDE = 1 << 20;
    private static final int MAX_INT = Integer.MAX_VALUE;

    private MessageCodec() {}

    public static byte[] encode(Message message) {
        var out = new WireWriter();
        out.unsignedByte(MAGIC >> 8).unsignedByte(MAGIC & 0xff).unsignedByte(VERSION).unsignedByte(kind(message)).uuid(message.session());
        switch (message) {
            case OpenSession m -> out.text(m.release(), Message.TEXT_BYTES);
            case SessionOpened m -> out.text(m.release(), Message.TEXT_BYTES).int32(m.threads()).int64(m.memory());
            case UpdateFrame m -> out.int64(m.call()).int32(m.frame()).hash(m.manifest()).int32(m.manifestBytes());
            case FrameUpdated m ->
                    out.int64(m.call()).bool(m.traced()).text(m.plan(), Message.TEXT_BYTES).int64(m.rays()).int64(m.nanoseconds())
                            .int32(m.width()).int32(m.height()).int64(m.memory()).int64(m.disk());
            case UpdateFailed m -> out.int64(m.call()).unsignedByte(m.reason().ordinal()).text(m.message(), Message.TEXT_BYTES);
            case CancelUpdate m -> out.int64(m.call());
            case RequestContent m -> out.hash(m.hash()).int64(m.offset());
            case ContentPart m -> out.hash(m.hash()).int64(m.offset()).bytes(m.bytes());
            case RequestTiles m -> out.int64(m.call()).int32(m.frame()).int32(m.maxWidth()).int32(m.maxHeight()).int32(m.firstTile())
                    .int32(m.tileCount());
            case FilmTileData m -> out.int64(m.call()).int32(m.frame()).int32(m.maxWidth()).int32(m.maxHeight()).int32(m.firstTile())
                    .bytes(m.bytes());
            case FilmUnavailable m -> out.int64(m.call()).int32(m.frame());
            case FocusFrame m -> out.int32(m.frame());
            case DropFrame m -> out.int32(m.frame());
            case Heartbeat _,CloseSession _ -> {
                // No fields except the session.
            }
        }
        return out.toBytes();
    }

    private static int kind(Message message) {
        return switch (message) {
            case OpenSession _ -> 1;
            case SessionOpened _ -> 2;
            case UpdateFrame _ -> 3;
            case FrameUpdated _ -> 4;
            case UpdateFailed _ -> 5;
            case CancelUpdate _ -> 6;
            case RequestContent _ -> 7;
            case ContentPart _ -> 8;
            case RequestTiles _ -> 9;
            case FilmTileData _ -> 10;
            case FilmUnavailable _ -> 11;
            case FocusFrame _ -> 12;
            case DropFrame _ -> 13;
            case CloseSession _ -> 14;
            case Heartbeat _ -> 15;
        };
    }

    /** @throws WireException if the bytes are not exactly one message of this version */
    public static Message decode(byte[] bytes) throws WireException {
        if (bytes.length > Message.MAX_BYTES) {
            throw new WireException("expected at most " + Message.MAX_BYTES + " bytes, found " + bytes.length);
        }
        var in = new WireReader(bytes);
        int magic = in.unsignedByte("the magic number") << 8 | in.unsignedByte("the magic number");
        if (magic != MAGIC) {
            throw WireReader.invalid(0, "the magic number", String.valueOf(MAGIC), magic);
        }
        int version = in.unsignedByte("the version");
        if (version != VERSION) {
            throw new WireException("at byte 2: expected protocol version " + VERSION + ", found " + version
                    + "; all machines must run the same release");
        }
        int kind = in.unsignedByte("the kind");
        UUID session = in.uuid("the session");
        Message message = body(kind, session, in);
        in.requireEnd();
        return message;
    }

    private static Message body(int kind, UUID session, WireReader in) throws WireException {
        return switch (kind) {
            case 1 -> new OpenSession(session, in.text("the release", Message.TEXT_BYTES));
            case 2 -> new SessionOpened(session, in.text("the release", Message.TEXT_BYTES), in.int32("threads", MAX_INT),
                    in.int64("memory"));
            case 3 -> new UpdateFrame(session, in.int64("the request"), frame(in), in.hash("the manifest"),
                    in.int32("the manifest's size", MAX_INT));
            case 4 -> new FrameUpdated(session, in.int64("the request"), in.bool("traced"), in.text("the plan", Message.TEXT_BYTES),
                    in.int64("rays"), in.int64("nanoseconds"), in.int32("the width", MAX_SIDE), in.int32("the height", MAX_SIDE),
                    in.int64("memory"), in.int64("disk"));
            case 5 -> new UpdateFailed(session, in.int64("the request"), reason(in), in.text("the message", Message.TEXT_BYTES));
            case 6 -> new CancelUpdate(session, in.int64("the request"));
            case 7 -> new RequestContent(session, in.hash("the content"), in.int64("the offset"));
            case 8 -> new ContentPart(session, in.hash("the content"), in.int64("the offset"), in.bytes("the part", Message.PART_BYTES));
            case 9 -> new RequestTiles(session, in.int64("the request"), frame(in), in.int32("the maximum width", MAX_SIDE),
                    in.int32("the maximum height", MAX_SIDE), in.int32("the first tile", MAX_SIDE), in.int32("tiles", MAX_SIDE));
            case 10 -> new FilmTileData(session, in.int64("the request"), frame(in), in.int32("the maximum width", MAX_SIDE),
                    in.int32("the maximum height", MAX_SIDE), in.int32("the first tile", MAX_SIDE),
                    in.bytes("the pixels", Message.PART_BYTES));
            case 11 -> new FilmUnavailable(session, in.int64("the request"), frame(in));
            case 12 -> new FocusFrame(session, frame(in));
            case 13 -> new DropFrame(session, frame(in));
            case 14 -> new CloseSession(session);
            case 15 -> new Heartbeat(session);
            default -> throw WireReader.invalid(3, "the kind", "1 to 15", kind);
        };
    }

    private static int frame(WireReader in) throws WireException {
        return in.int32("the frame", MAX_INT);
    }

    private static FailureReason reason(WireReader in) throws WireException {
        int reason = in.unsignedByte("the reason");
        if (reason >= FailureReason.values().length) {
            throw new WireException("expected a reason below " + FailureReason.values().length + ", found " + reason);
        }
        return FailureReason.values()[reason];
    }
}
