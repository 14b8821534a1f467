/** Lightning: ray-traced scenes, relit exactly in a fraction of a full trace. */
module lightning {
    requires java.desktop;
    requires jdk.incubator.vector;
    requires info.picocli;
    requires org.apache.commons.imaging;

    opens lightning.cli to info.picocli;
}
