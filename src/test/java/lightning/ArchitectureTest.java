package lightning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.ToolProvider;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program keeps the rules of {@link Architecture}, and the rules catch what breaks them. */
@Slow
class ArchitectureTest {
    private static final JavaClasses PROGRAM = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("lightning");

    @TempDir
    private Path folder;

    @Test
    void program_isSeenByTheRules() {
        assertThat(PROGRAM.contain("lightning.Main")).isTrue();
        assertThat(PROGRAM.contain("lightning.scene.Scene")).isTrue();
        assertThat(PROGRAM.contain("lightning.ArchitectureTest")).isFalse();
    }

    @Test
    void program_rowsKnowOnlyRowsAbove() {
        Architecture.rowsKnowOnlyRowsAbove().check(PROGRAM);
    }

    @Test
    void rows_areToldOnlyRowsBeforeThem() {
        assertThat(Architecture.rowsToldALaterOne()).isEmpty();
    }

    @Test
    void rows_standInTheOrderOfTheirGroups() {
        assertThat(Architecture.rowsOutOfGroup()).isEmpty();
    }

    @Test
    void program_hasOneClassOfEachName() {
        Architecture.classesHaveNamesOfTheirOwn().check(PROGRAM);
    }

    @Test
    void program_onlyAppSeesJavaFx() {
        Architecture.onlyAppSeesJavaFx().check(PROGRAM);
    }

    @Test
    void program_onlyCommandsPrint() {
        Architecture.onlyCommandsPrint().check(PROGRAM);
    }

    @Test
    void program_checkedExceptionsAreTold() {
        Architecture.checkedExceptionsAreTold().check(PROGRAM);
    }

    @Test
    void exceptionThatNobodyCanRead_isCaught() throws IOException {
        assertCaught(Architecture.checkedExceptionsAreTold(), "checked exceptions are for users to read",
                "package lightning.format.mesh; class Bad extends Exception {}");
    }

    @Test
    void program_opensNamedFilesInOnePlace() {
        Architecture.namedFilesAreOpenedInOnePlace().check(PROGRAM);
    }

    @Test
    void fileOpenedWithoutACheck_isCaught() throws IOException {
        assertCaught(Architecture.namedFilesAreOpenedInOnePlace(), "only OrdinaryFile opens files that users name",
                "package lightning.format.mesh; class Bad { Object in(java.nio.file.Path file) throws java.io.IOException {"
                        + " return java.nio.file.Files.newInputStream(file); } }");
        assertCaught(Architecture.namedFilesAreOpenedInOnePlace(), "only OrdinaryFile opens files that users name",
                "package lightning.format.mesh; class Bad { Object in(String file) throws java.io.IOException {"
                        + " return new java.io.FileInputStream(file); } }");
    }

    @Test
    void program_referenceTracerKnowsNoFastCode() {
        Architecture.referenceTracerKnowsNoFastCode().check(PROGRAM);
    }

    @Test
    void program_menusHaveItemsOfCommandsOnly() {
        Architecture.onlyCommandItemsMakeItems().check(PROGRAM);
    }

    @Test
    void itemWithoutACommand_isCaught() throws IOException {
        assertCaught(Architecture.onlyCommandItemsMakeItems(), "only CommandItems makes items of menus",
                "package javafx.scene.control; public class MenuItem {}",
                "package javafx.scene.control; public class RadioMenuItem extends MenuItem {}",
                "package lightning.editor.window.property; class Bad { Object item = new javafx.scene.control.RadioMenuItem(); }");
    }

    @Test
    void secondClassOfAName_isCaught() throws IOException {
        assertCaught(Architecture.classesHaveNamesOfTheirOwn(), "no two classes have one name",
                "package lightning.base.math; public class Thing {}",
                "package lightning.scene; class Thing { int count; }");
    }

    @Test
    void lowerRowKnowingAHigherOne_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lightning.base.math knows only rows above it",
                "package lightning.scene; public class Thing {}",
                "package lightning.base.math; class Bad { lightning.scene.Thing thing; }");
    }

    @Test
    void narrowedRowKnowingARowAbove_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lightning.render.image knows only rows above it",
                "package lightning.scene; public class Thing {}",
                "package lightning.render.image; class Bad { lightning.scene.Thing thing; }");
    }

    @Test
    void commandKnowingTheEditor_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lightning.cli knows only rows above it",
                "package lightning.editor.window; public class Window {}",
                "package lightning.cli; class Bad { lightning.editor.window.Window window; }");
    }

    @Test
    void planKnowingTheTiles_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lightning.render.relight.plan knows only rows above it",
                "package lightning.render.relight.tile; public class Worker {}",
                "package lightning.render.relight.plan; class Bad { lightning.render.relight.tile.Worker worker; }");
    }

    @Test
    void paneKnowingAnotherPane_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lightning.editor.window.traced knows only rows above it",
                "package lightning.editor.window.preview; public class Pane {}",
                "package lightning.editor.window.traced; class Bad { lightning.editor.window.preview.Pane pane; }");
    }

    @Test
    void packageKnowingWhatStartsTheProgram_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lightning.cli knows only rows above it",
                "package lightning; public class Main {}",
                "package lightning.cli; class Bad { lightning.Main main; }");
    }

    @Test
    void packageWithoutARow_isCaught() throws IOException {
        assertCaught(Architecture.rowsKnowOnlyRowsAbove(), "lives in a package that has a row",
                "package lightning.util; class Bad {}");
    }

    @Test
    void higherRowKnowingALowerOne_isAllowed() throws IOException {
        JavaClasses classes = compiled("package lightning.base.math; public class Number {}",
                "package lightning.render.trace; class Good { lightning.base.math.Number number; }");
        assertThatCode(() -> Architecture.rowsKnowOnlyRowsAbove().check(classes)).doesNotThrowAnyException();
    }

    @Test
    void javaFxOutsideTheEditor_isCaught() throws IOException {
        assertCaught(Architecture.onlyAppSeesJavaFx(), "only lightning.editor.window sees JavaFX",
                "package javafx.scene; public class Node {}",
                "package lightning.editor.document; class Bad { javafx.scene.Node node; }");
    }

    @Test
    void printingInTheEngine_isCaught() throws IOException {
        assertCaught(Architecture.onlyCommandsPrint(), "print",
                "package lightning.render.relight; class Bad { void say() { System.out.println(); } }");
    }

    @Test
    void printingInACommand_isAllowed() throws IOException {
        JavaClasses classes = compiled(
                "package lightning.cli; class Good { void say() { System.err.println(); } }");
        assertThatCode(() -> Architecture.onlyCommandsPrint().check(classes)).doesNotThrowAnyException();
    }

    @Test
    void referenceTracerReachingFastCodeThroughAHelper_isCaught() throws IOException {
        assertCaught(Architecture.referenceTracerKnowsNoFastCode(), "the reference tracer knows neither",
                "package lightning.render.trace.solid; public class SphereLanes {}",
                "package lightning.render.trace; public class Nearest { lightning.render.trace.solid.SphereLanes lanes; }",
                "package lightning.render.shading; class ReferenceTracer { lightning.render.trace.Nearest nearest; }");
    }

    @Test
    void referenceTracerKnowingAnEngine_isCaught() throws IOException {
        assertCaught(Architecture.referenceTracerKnowsNoFastCode(), "the reference tracer knows neither",
                "package lightning.render.engine; public class Crew {}",
                "package lightning.render.shading; class ReferenceTracer { lightning.render.engine.Crew crew; }");
    }

    @Test
    void referenceTracerAskingATree_isCaught() throws IOException {
        assertCaught(Architecture.referenceTracerKnowsNoFastCode(), "asks every shape, and no tree of boxes",
                "package lightning.render.trace.tree; public class Bvh {}",
                "package lightning.render.shading; class ReferenceTracer { lightning.render.trace.tree.Bvh bvh; }");
    }

    @Test
    void referenceTracerKnowingTheCache_isCaught() throws IOException {
        assertCaught(Architecture.referenceTracerKnowsNoFastCode(), "the reference tracer knows neither",
                "package lightning.render.cache; public class Rows {}",
                "package lightning.render.shading; class ReferenceTracer { void use() { new lightning.render.cache.Rows(); } }");
    }

    private void assertCaught(ArchRule rule, String sentence, String... sources) throws IOException {
        JavaClasses classes = compiled(sources);
        assertThatThrownBy(() -> rule.check(classes))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining(sentence);
    }

    /** Compiles classes, each given as its source on one line, in a folder of their own. */
    private JavaClasses compiled(String... sources) throws IOException {
        var compiler = ToolProvider.getSystemJavaCompiler();
        List<Path> files = new ArrayList<>();
        for (String source : sources) {
            String type = source.replaceFirst(".*?class (\\w+) .*", "$1");
            Path file = folder.resolve("source" + files.size()).resolve(type + ".java");
            Files.createDirectories(file.getParent());
            files.add(Files.writeString(file, source));
        }
        Path classes = folder.resolve("classes");
        var messages = new StringWriter();
        try (var manager = compiler.getStandardFileManager(null, null, null)) {
            boolean compiled = compiler.getTask(messages, manager, null,
                    List.of("-proc:none", "-cp", folder.toString(), "-d", classes.toString()), null,
                    manager.getJavaFileObjectsFromPaths(files)).call();
            assertThat(compiled).as(messages.toString()).isTrue();
        }
        return new ClassFileImporter().importPath(classes);
    }
}
