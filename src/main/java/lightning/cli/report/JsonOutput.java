package lightning.cli.report;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.io.PrintStream;
import java.util.List;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.StreamWriteFeature;
import tools.jackson.databind.PropertyNamingStrategies;
import tools.jackson.databind.SerializationContext;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.module.SimpleModule;
import tools.jackson.databind.ser.std.StdSerializer;

/**
 * The JSON object that a command prints with {@code --json}.
 *
 * @param command  full name without {@code lightning}, such as {@code shot render}
 * @param exitCode exit code of the process
 * @param result   record of the command; absent if it failed before its end
 * @param text     lines of a command without a record, in order; absent otherwise
 * @param notes    lines that the command prints to the error stream without {@code --json}
 * @param errors   errors, in order; empty if the command succeeded
 */
public record JsonOutput(String command, int exitCode, Object result, List<String> text, List<String> notes, List<ErrorReport> errors) {
    private static final JsonMapper MAPPER = JsonMapper.builder().propertyNamingStrategy(PropertyNamingStrategies.SNAKE_CASE)
            .changeDefaultPropertyInclusion(_ -> JsonInclude.Value.construct(JsonInclude.Include.NON_NULL, JsonInclude.Include.ALWAYS))
            .enable(SerializationFeature.INDENT_OUTPUT).disable(StreamWriteFeature.AUTO_CLOSE_TARGET)
            .addModule(new SimpleModule().addSerializer(Double.class, new FiniteNumbers()).addSerializer(double.class, new FiniteNumbers()))
            .build();

    /** Prints the object and a line end. */
    public void print(PrintStream out) {
        out.println(MAPPER.writeValueAsString(this));
    }

    /** Writes numbers that JSON does not have, infinity and not-a-number, as null. */
    private static final class FiniteNumbers extends StdSerializer<Double> {
        FiniteNumbers() {
            super(Double.class);
        }

        @Override
        public void serialize(Double value, JsonGenerator json, SerializationContext context) {
            if (Double.isFinite(value)) {
                json.writeNumber(value.doubleValue());
            } else {
                json.writeNull();
            }
        }
    }
}
