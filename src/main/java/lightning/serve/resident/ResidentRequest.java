package lightning.serve.resident;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * A request to the resident process.
 *
 * @param surroundings hash of the surroundings of the client: {@link Surroundings}
 * @param stop         true to end the process; the rest is then ignored
 * @param terminal     true if the client's standard output is a terminal
 * @param charset      name of the charset of the client's standard output
 * @param arguments    the command line
 */
record ResidentRequest(String surroundings, boolean stop, boolean terminal, String charset, List<String> arguments) {
    /** Longest command line in bytes, about what systems allow. */
    private static final int MAX_BYTES = 4 << 20;

    static ResidentRequest read(DataInputStream in) throws IOException {
        String surroundings = in.readUTF();
        boolean stop = in.readBoolean();
        boolean terminal = in.readBoolean();
        String charset = in.readUTF();
        int count = in.readInt();
        int left = MAX_BYTES;
        List<String> arguments = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int length = in.readInt();
            left -= Math.max(length, 1);
            if (length < 0 || left < 0) {
                throw new IOException("expected a command line of at most " + MAX_BYTES + " bytes");
            }
            arguments.add(new String(in.readNBytes(length), StandardCharsets.UTF_8));
        }
        return new ResidentRequest(surroundings, stop, terminal, charset, arguments);
    }

    void write(DataOutputStream out) throws IOException {
        out.writeUTF(surroundings);
        out.writeBoolean(stop);
        out.writeBoolean(terminal);
        out.writeUTF(charset);
        out.writeInt(arguments.size());
        for (String argument : arguments) {
            byte[] bytes = argument.getBytes(StandardCharsets.UTF_8);
            out.writeInt(bytes.length);
            out.write(bytes);
        }
        out.flush();
    }
}
