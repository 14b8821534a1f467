package lightning.sample;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.junit.platform.launcher.core.LauncherConfig;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

class SkippedTestsTest {
    static class Examples {
        @Test
        @Disabled("until\nlater")
        void disabled() {}

        @ParameterizedTest
        @ValueSource(strings = {"pxr", "java"})
        void missing(String program) {
            Assumptions.assumeTrue(program.equals("java"), "no " + program);
        }
    }

    @Disabled
    static class OtherSystem {
        @Test
        void any() {}
    }

    @Test
    void skippedTests_areListedWithTheirReasonOnOneLine(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("new/1");
        LauncherFactory.create(LauncherConfig.builder().enableTestExecutionListenerAutoRegistration(false).build()).execute(
                LauncherDiscoveryRequestBuilder.request().selectors(selectClass(Examples.class), selectClass(OtherSystem.class)).build(),
                new SkippedTests(file));
        String type = SkippedTestsTest.class.getName();
        assertThat(Files.readAllLines(file)).containsExactlyInAnyOrder(type + "$Examples#disabled: until later",
                type + "$Examples#missing [1] program=pxr: no pxr",
                type + "$OtherSystem: class " + type + "$OtherSystem is @Disabled");
    }
}
