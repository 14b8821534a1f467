package lightning.bench;

/**
 * The computer that measured, in general terms.
 *
 * @param system      operating system and instruction set
 * @param processor   the processor's model name; {@code unknown} where the system does not report it
 * @param processors  how many processors the program may use
 * @param vectorBits  the width of its vectors, bits
 * @param memoryBytes physical memory, bytes
 * @param heapBytes   how much of it the program may use for objects, bytes
 * @param java        name and version of the Java machine
 */
public record MachineSpec(String system, String processor, int processors, int vectorBits, long memoryBytes, long heapBytes, String java) {}
