package lightning.shot.cluster;

import java.io.DataInput;
import java.io.IOException;
import org.jgroups.LongMessage;
import org.jgroups.Message;
import org.jgroups.MessageFactory;
import org.jgroups.ObjectMessage;
import org.jgroups.conf.ClassConfigurator;
import org.jgroups.util.Digest;
import org.jgroups.util.MutableDigest;
import org.jgroups.util.SeqnoList;
import org.jgroups.util.SizeStreamable;

/**
 * Whitelist of JGroups messages: bytes, empty messages, and the protocols' own payloads: flow-control credits, sequence numbers to
 * retransmit, and digests of received messages. Retransmission and flow control need these. All other messages are rejected, because they
 * would instantiate classes named in the message.
 */
final class RestrictedMessageFactory extends MessageFactory {
    private RestrictedMessageFactory() {}

    /** Installs it for this process. */
    static synchronized void install() {
        for (int type = 0; type < creators.length; type++) {
            creators[type] = switch (type) {
                case Message.BYTES_MSG, Message.EMPTY_MSG -> creators[type];
                case Message.LONG_MSG -> LongMessage::new;
                case Message.OBJ_MSG -> SequenceMessage::new;
                default -> null;
            };
        }
    }

    /** Message written as a generic object, but read in one of two known formats. */
    private static final class SequenceMessage extends ObjectMessage {
        private static final short SEQUENCE_LIST = ClassConfigurator.getMagicNumber(SeqnoList.class);
        private static final short DIGEST = ClassConfigurator.getMagicNumber(Digest.class);
        private static final short MUTABLE_DIGEST = ClassConfigurator.getMagicNumber(MutableDigest.class);

        @Override
        public void readPayload(DataInput in) throws IOException, ClassNotFoundException {
            if (in.readByte() == 0) {
                return;
            }
            short kind = in.readShort();
            // Both kinds of digest have the same format.
            SizeStreamable payload =
                    kind == SEQUENCE_LIST ? new BoundedSequenceList() : kind == DIGEST || kind == MUTABLE_DIGEST ? new Digest() : null;
            if (payload == null) {
                throw new IOException("expected sequence numbers, found an object of kind " + kind);
            }
            payload.readFrom(in);
            obj = payload;
        }
    }

    /** List of sequence numbers, limited to the maximum that a protocol requests at a time. */
    private static final class BoundedSequenceList extends SeqnoList {
        private static final int MAX_SIZE = 1 << 20;

        @Override
        public void readFrom(DataInput in) throws IOException {
            size = in.readInt();
            if (size < 1 || size > MAX_SIZE) {
                throw new IOException("expected 1 to " + MAX_SIZE + " sequence numbers, found " + size);
            }
            offset = in.readLong();
            words = new long[(size + Long.SIZE - 1) / Long.SIZE];
            for (int i = 0; i < words.length; i++) {
                words[i] = in.readLong();
            }
        }
    }
}
