package lightning.serve;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.core.exc.UnexpectedEndOfInputException;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.exc.MismatchedInputException;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Reader of JSON messages, one a line, with limits that no line can exceed. */
final class JsonLines {
    /** Longest line in bytes. A larger scene is opened from a file. */
    static final int MAX_LINE = 4 << 20;
    /** Deepest message: an array in an object, and some more for clear messages about the rest. */
    private static final int MAX_DEPTH = 8;
    private static final int MAX_NUMBER = 40;

    static final JsonMapper JSON = JsonMapper
            .builder(JsonFactory.builder()
                    .streamReadConstraints(StreamReadConstraints.builder().maxNestingDepth(MAX_DEPTH).maxNumberLength(MAX_NUMBER)
                            .maxStringLength(MAX_LINE).build())
                    .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build())
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS).build();

    private final InputStream in;
    private final byte[] buffer = new byte[1 << 16];
    private int start;
    private int end;

    JsonLines(InputStream in) {
        this.in = in;
    }

    /**
     * Returns the bytes of the next line that is not blank, without its end; null at the end of the input. A last line needs no end.
     *
     * @throws RequestException if the line is too long; the next call continues after it
     */
    byte @Nullable [] next() throws IOException {
        var line = new ByteArrayOutputStream();
        boolean isTooLong = false;
        while (true) {
            if (start == end) {
                start = 0;
                end = in.read(buffer);
                if (end < 0) {
                    end = 0;
                    return isTooLong || isBlank(line) ? null : line.toByteArray();
                }
            }
            int stop = start;
            while (stop < end && buffer[stop] != '\n') {
                stop++;
            }
            isTooLong |= line.size() + stop - start > MAX_LINE;
            if (!isTooLong) {
                line.write(buffer, start, stop - start);
            }
            boolean isComplete = stop < end;
            start = isComplete ? stop + 1 : stop;
            if (isComplete && isTooLong) {
                throw new RequestException(ErrorCode.BAD_MESSAGE, "", "a message may have at most " + MAX_LINE + " bytes");
            }
            if (isComplete && !isBlank(line)) {
                return line.toByteArray();
            }
            if (isComplete) {
                line.reset();
            }
        }
    }

    private static boolean isBlank(ByteArrayOutputStream line) {
        return line.size() == 0 || line.size() == 1 && line.toByteArray()[0] == '\r';
    }

    /**
     * Parses a message.
     *
     * @throws RequestException if the line is not one JSON object
     */
    static ObjectNode parse(byte[] line) {
        JsonNode node;
        try {
            node = JSON.readTree(line);
        } catch (JacksonException e) {
            var at = e.getLocation();
            throw new RequestException(ErrorCode.BAD_MESSAGE, at == null ? "" : "column " + at.getColumnNr(),
                    "expected one JSON object a line" + reason(e));
        }
        if (!(node instanceof ObjectNode message)) {
            throw new RequestException(ErrorCode.BAD_MESSAGE, "", "expected a JSON object, such as {\"id\": 1, \"method\": \"list\"}");
        }
        return message;
    }

    private static String reason(JacksonException e) {
        return switch (e) {
            case StreamConstraintsException _ ->
                    ", at most " + MAX_DEPTH + " levels deep, with numbers of at most " + MAX_NUMBER + " characters";
            case UnexpectedEndOfInputException _ -> ", found the end of the line";
            case MismatchedInputException _ -> ", found more after the first";
            default -> ": " + e.getOriginalMessage().lines().findFirst().orElse("");
        };
    }
}
