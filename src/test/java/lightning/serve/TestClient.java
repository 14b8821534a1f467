package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.Pipe;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** Client of a server in the same process, over pipes. */
final class TestClient implements AutoCloseable {
    private final Client client;
    private final Closeable[] ends;
    private final OutputStream requests;
    private final BufferedReader answers;
    private final List<JsonNode> others = new ArrayList<>();
    private int lastId;

    TestClient(Server server) throws IOException {
        Pipe in = Pipe.open();
        Pipe out = Pipe.open();
        ends = new Closeable[] {in.sink(), in.source(), out.source(), out.sink()};
        requests = Channels.newOutputStream(in.sink());
        answers = new BufferedReader(new InputStreamReader(Channels.newInputStream(out.source()), StandardCharsets.UTF_8));
        client = server.connect(Channels.newInputStream(in.source()), Channels.newOutputStream(out.sink()), out.sink());
    }

    /** Sends a line as it is. */
    void sendLine(String line) throws IOException {
        sendBytes((line + "\n").getBytes(StandardCharsets.UTF_8));
    }

    void sendBytes(byte[] bytes) throws IOException {
        requests.write(bytes);
        requests.flush();
    }

    /** Sends a request; returns its id. Quotes in {@code fields} are single, and become double. */
    int send(String method, String fields) throws IOException {
        lastId++;
        sendLine("{\"id\":" + lastId + ",\"method\":\"" + method + "\"" + (fields.isEmpty() ? "" : "," + fields.replace('\'', '"')) + "}");
        return lastId;
    }

    /** Returns the next message. */
    JsonNode read() throws IOException {
        String line = answers.readLine();
        return line == null ? null : JsonLines.JSON.readTree(line);
    }

    /** Returns the answer of a request. Messages of other requests are kept. */
    JsonNode answer(int id) throws IOException {
        for (JsonNode message = read(); message != null; message = read()) {
            if (message.has("id") && message.get("id").asInt(-1) == id && !message.has("progress")) {
                return message;
            }
            others.add(message);
        }
        throw new IOException("no answer to " + id);
    }

    /** Returns the messages that {@link #answer} passed over. */
    List<JsonNode> others() {
        return others;
    }

    /** Sends a request and returns its result, which must not be an error. */
    JsonNode request(String method, String fields) throws IOException {
        JsonNode answer = answer(send(method, fields));
        assertThat(answer.has("error")).as(answer.toString()).isFalse();
        return answer.get("result");
    }

    /** Sends a request with these fields, as {@link #request(String, String)} does. */
    JsonNode request(String method, ObjectNode fields) throws IOException {
        JsonNode answer = answer(send(method, fields));
        assertThat(answer.has("error")).as(answer.toString()).isFalse();
        return answer.get("result");
    }

    /** Sends a request with these fields and returns its error. */
    JsonNode refused(String method, ObjectNode fields) throws IOException {
        JsonNode answer = answer(send(method, fields));
        assertThat(answer.has("error")).as(answer.toString()).isTrue();
        return answer.get("error");
    }

    private int send(String method, ObjectNode fields) throws IOException {
        lastId++;
        sendLine(fields.deepCopy().put("id", lastId).put("method", method).toString());
        return lastId;
    }

    /** Sends a request and returns its error. */
    JsonNode refused(String method, String fields) throws IOException {
        JsonNode answer = answer(send(method, fields));
        assertThat(answer.has("error")).as(answer.toString()).isTrue();
        return answer.get("error");
    }

    /** Opens a text; returns the scene's number. */
    int open(String text) throws IOException {
        lastId++;
        ObjectNode message = JsonLines.JSON.createObjectNode().put("id", lastId).put("method", "open").put("text", text);
        sendLine(message.toString());
        JsonNode answer = answer(lastId);
        assertThat(answer.has("error")).as(answer.toString()).isFalse();
        return answer.get("result").get("scene").asInt();
    }

    /** Renders a scene into shared memory; returns its rows. */
    float[] picture(int scene, String fields) throws IOException {
        return floats(request("render", "'scene':" + scene + ",'memory':true" + (fields.isEmpty() ? "" : "," + fields)));
    }

    static float[] floats(JsonNode result) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(Path.of(result.get("memory").get("path").asString())))
                .order(ByteOrder.LITTLE_ENDIAN);
        float[] rgb = new float[bytes.remaining() / Float.BYTES];
        bytes.asFloatBuffer().get(rgb);
        return rgb;
    }

    /** Ends the input and waits until the server has answered everything. */
    void finish() throws IOException, InterruptedException {
        ends[0].close();
        client.awaitEnd();
    }

    /** Vanishes, as a process that is killed. */
    @Override
    public void close() throws IOException {
        for (Closeable end : ends) {
            end.close();
        }
    }
}
