/** Lightning: interactive relighting of ray-traced scenes, exact in a fraction of a full render's time. */
module lightning {
    requires java.desktop;
    requires java.logging;
    requires java.management;
    requires jdk.management;
    requires jdk.incubator.vector;
    requires info.picocli;
    requires io.github.javadiffutils;
    requires tools.jackson.databind;
    requires tools.jackson.dataformat.csv;
    requires javafx.controls;
    requires atlantafx.base;
    requires org.kordamp.ikonli.javafx;
    requires org.kordamp.ikonli.materialdesign2;
    requires org.jgroups;
    requires ojalgo;
    requires io.nayuki.qrcodegen;
    // Automatic.
    requires drako;
    requires com.twelvemonkeys.imageio.webp;
    requires com.twelvemonkeys.imageio.tga;
    // Only in the process that converts other programs' files, which has a class path.
    requires static org.lwjgl;
    requires static org.lwjgl.assimp;
    // Compile-time annotations only; not needed at run time.
    requires static io.soabase.recordbuilder.core;
    requires static java.compiler;
    requires static org.jspecify;

    // The engine as a library: docs/library.md.
    exports lightning.base.math;
    exports lightning.base.work;
    exports lightning.scene;
    exports lightning.scene.asset;
    exports lightning.scene.attribute;
    exports lightning.scene.light;
    exports lightning.scene.material;
    exports lightning.scene.node;
    exports lightning.scene.value;
    exports lightning.format.jen;
    exports lightning.format.image;
    exports lightning.render;
    exports lightning.render.image;
    exports lightning.render.relight;
    exports lightning.render.relight.paper;
    exports lightning.render.relight.plan;
    exports lightning.render.shading;

    exports lightning.editor.window to javafx.graphics;
    opens lightning.cli to info.picocli;
    opens lightning.cli.option to info.picocli;
    opens lightning.cli.output to info.picocli;
    opens lightning.format.ocio to tools.jackson.databind;
    opens lightning.format.json to tools.jackson.databind;
    opens lightning.cli.report to tools.jackson.databind;
    opens lightning.bench.accuracy to tools.jackson.databind;
    opens lightning.render.measure to tools.jackson.databind;
    opens lightning.bench.result to tools.jackson.databind;
}
