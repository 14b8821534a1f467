package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Result of a command.
 *
 * @param exit exit code
 */
record CliResult(int exit, String out, String err) {
    /** Small scene with every type of light, a reflection and a shadow. */
    static final String SCENE = """
            jen 1
            picture { size 48 32  depth 2 }
            camera { from 0 2 7  to 0 0.5 0  fov 35 }
            world { ambience 0.5  background 0.1 0.1 0.2 }
            material floor { diffuse 0.7 0.7 0.6  reflective 0.2 0.3 0.2 }
            material red { ambient 0.1 0 0  diffuse 0.8 0.1 0.1  specular 0.4 0.4 0.4  shininess 20 }
            plane ground { material floor  scale 8 1 8 }
            sphere ball { material red  at 0 1 0 }
            cone hat { material red  at 2 0 0.5 }
            # what lights it
            light lamp point { at -3 4 3  attenuation 0.2 0.1 0.02 }
            light sun directional { direction 0.4 -1 -0.5  intensity 0.4 }
            light stage spot { at 0 5 3  direction 0 -5 -3  angle 20  dropoff 4 }
            """;

    static CliResult run(Object... arguments) {
        String[] words = new String[arguments.length];
        for (int i = 0; i < words.length; i++) {
            words[i] = arguments[i].toString();
        }
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int exit = Lightning.run(new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8), words);
        return new CliResult(exit, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    static Path scene(Path folder) throws IOException {
        return Files.writeString(folder.resolve("a.jen"), SCENE);
    }

    /** Asserts bad input: exit code 2, and only messages that contain the given words. */
    void assertRejected(String... words) {
        assertThat(exit).as(err).isEqualTo(2);
        assertThat(out).isEmpty();
        assertThat(err).contains(words).doesNotContain("Exception", "\tat ", "internal error");
    }

    CliResult assertSuccess() {
        assertThat(exit).as(err).isZero();
        return this;
    }
}
